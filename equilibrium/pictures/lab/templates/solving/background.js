// Long work. Here it runs a few milliseconds at a time, so that dragging never stutters; in a worker so that
// new questions are heard.
// Runs a generator; `done` takes what it returns, `early` what it yields, if that is anything. Returns
// what stops it.
function inSlices(search, done, { first = 12, later = 6, early = done } = {}) {
  let stopped = false;
  const run = (budget) => {
    const end = performance.now() + budget;
    while (!stopped) {
      const step = search.next();
      if (step.done) { done(step.value); return; }
      if (step.value) early(step.value);
      if (performance.now() > end) { setTimeout(() => run(later), 0); return; }
    }
  };
  run(first);
  return () => { stopped = true; };
}

// In a worker: answers a question part by part, until the next one comes.
function serve(answers) {
  let stop = () => {};
  onmessage = ({ data: { number, question } }) => {
    stop();
    stop = inSlices(answers(question), () => postMessage({ number }), { later: 20, early: (part) => postMessage({ number, part }) });
  };
}

// What puts questions to a worker that runs the page's script `decides`, or where there can be none, to this
// page. `take(part, question)` gets the parts of the answers, `ended` is called after the last one.
// While questions come fast each gets its first part, if that does not take long.
function asking(answers, take, ended) {
  /** @type {Worker | null} */
  let worker = null;
  let [number, stop, asked, next, waits] = [0, () => {}, null, null, false];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const put = (question) => {
    clearTimeout(timer);
    [number, asked, next, waits] = [number + 1, question, null, true];
    if (worker) worker.postMessage({ number, question });
    else {
      stop();
      stop = inSlices(answers(question), ended, { early: (part) => take(part, question) });
    }
  };
  try {
    const source = `${document.getElementById("decides").textContent}\n${serve.name}(${answers.name});`;
    worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
    worker.onmessage = ({ data: said }) => {
      if (said.number !== number) return;
      if (said.part) take(said.part, asked);
      waits = false;
      if (next) put(next);
      else if (!said.part) ended();
    };
    worker.onerror = () => { worker = null; if (asked) put(next ?? asked); };
  } catch { worker = null; }
  return (question) => {
    if (!worker || !waits) { put(question); return; }
    if (!next) timer = setTimeout(() => put(next), 120);
    next = question;
  };
}

// Promises of answers of one part, { value }, from a worker of its own, begun when it is needed. What is asked
// later, or `stop`, breaks the promise before.
function inBackground(answers) {
  /** @type {((question: any) => void) | null} */
  let put = null;
  /** @type {{ question: any, resolve: (value: any) => void, reject: (error: Error) => void } | null} */
  let open = null;
  const end = () => {
    open?.reject(new Error("Not checked to the end: something was changed. Check again."));
    open = null;
  };
  const take = ({ value }, question) => {
    if (question !== open?.question) return;
    open.resolve(value);
    open = null;
  };
  return {
    ask: (question) => new Promise((resolve, reject) => {
      end();
      open = { question, resolve, reject };
      put ??= asking(answers, take, () => {});
      put(question);
    }),
    stop() { if (open) { end(); put?.(null); } },
  };
}
