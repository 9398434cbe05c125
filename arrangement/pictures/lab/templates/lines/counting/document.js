// Arrangements as documents of the command line, and as part of an address.

// Throws an error that says what is wrong.
function readArrangement(document) {
  if (document === null || typeof document !== "object" || Array.isArray(document) || !Array.isArray(document.planes)) {
    throw new Error('this is not an arrangement: it needs "planes", a list of normals');
  }
  const { planes, offsets } = document;
  const dimension = planes.length ? planes[0]?.length : document.dimension ?? 3;
  if (document.schema_version !== 1) throw new Error("schema_version must be 1");
  if (dimension !== 2 && dimension !== 3) throw new Error("normals must have two entries (lines) or three (planes)");
  if (offsets !== undefined && (!Array.isArray(offsets) || offsets.length !== planes.length)) throw new Error("there must be as many offsets as planes");
  const rows = planes.map((normal, k) => {
    if (!Array.isArray(normal) || normal.length !== dimension) throw new Error(`plane ${k + 1} must have ${dimension} entries`);
    const entries = [...normal, ...(offsets || dimension === 2 ? [offsets?.[k] ?? "0"] : [])].map((value) => {
      const read = typeof value === "string" || Number.isInteger(value) ? readNumber(String(value)) : null;
      if (!read) throw new Error(`plane ${k + 1}: give ${NUMBER_RULE}, as a text`);
      return read;
    });
    if (dimension === 3 && entries[3]?.n) throw new Error(`plane ${k + 1} misses the origin; this page takes planes through the origin of R^3, or lines of R^2`);
    return entries.slice(0, 3);
  });
  const arrangement = { dimension, rows };
  const problem = problemOf(arrangement);
  if (problem) throw new Error(problem);
  return arrangement;
}

function problemOf({ dimension, rows }) {
  if (rows.length > data.most) return `${rows.length} planes; this page takes ${data.most}`;
  const k = rows.findIndex((row) => row.slice(0, dimension).every((x) => !x.n));
  if (k >= 0) return `${dimension === 2 ? "line" : "plane"} ${k + 1} has a normal of zeros`;
  return "";
}

function documentOf({ dimension, rows }) {
  const texts = rows.map((row) => row.map(textOf));
  const document = { schema_version: 1, planes: texts.map((row) => row.slice(0, dimension)) };
  if (dimension === 2) document.offsets = texts.map((row) => row[2]);
  if (!rows.length) document.dimension = dimension;
  return document;
}

// "1|3|1,0,0;0,1,0": version, dimension, rows.
const VERSION = "1";
const hashOf = ({ dimension, rows }) => [VERSION, dimension, rows.map((row) => row.map(textOf).join(",")).join(";")].join("|");

function readState(text) {
  const [version, dimension, list, ...more] = text.split("|");
  if (version !== VERSION) throw new Error(`the address is of version ${version.slice(0, 12)}; this page reads version ${VERSION}`);
  if (list === undefined || more.length || !["2", "3"].includes(dimension)) throw new Error("the address is not whole");
  const rows = list ? list.split(";").map((part, k) => {
    const row = part.split(",").map(readNumber);
    if (row.length !== 3 || row.includes(null)) throw new Error(`plane ${k + 1} of the address must be three numbers`);
    return row;
  }) : [];
  const arrangement = { dimension: Number(dimension), rows };
  const problem = problemOf(arrangement);
  if (problem) throw new Error(problem);
  return arrangement;
}
