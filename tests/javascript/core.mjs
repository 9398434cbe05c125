// The deciding modules of the slip lab without a page, for node: reads {"modules": [paths], "questions":
// [[grasp, wrench]], "certificates": [documents]} from stdin and writes {"answers", "reports"}.
import { readFileSync } from "node:fs";
import { runInThisContext } from "node:vm";

const { modules, questions, certificates, method } = JSON.parse(readFileSync(0, "utf8"));
const sources = modules.map((path) => readFileSync(path, "utf8"));
const core = runInThisContext(`"use strict"; (() => {
  ${sources.join("\n")}
  return { firstOf, readGrasp, readWrench, certificateOf, checkDocument, saidBy }; })()`);

const attempt = (action) => { try { return action(); } catch (error) { return { error: error.message }; } };
const answers = questions.map(([form, texts]) => attempt(() => {
  const [grasp, wrench] = [core.readGrasp(form), core.readWrench(texts)];
  if (method) return { stable: core.saidBy(method, grasp, wrench) };
  const found = core.firstOf(grasp, wrench);
  return { stable: found.stable, certificate: core.certificateOf(grasp, wrench, found) };
}));
const reports = certificates.map((document) => attempt(() => core.checkDocument(document)));
process.stdout.write(JSON.stringify({ answers, reports }));
