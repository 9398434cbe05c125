// Runs a generator a few milliseconds at a time, so that dragging never stutters; `done` takes what it
// returns, `early` what it yields, if that is anything. Returns what stops it.
function inSlices(search, done, first = 12, early = done) {
  let stopped = false;
  const run = (budget) => {
    if (stopped) return;
    const end = performance.now() + budget;
    for (;;) {
      const step = search.next();
      if (step.done) { done(step.value); return; }
      if (step.value) early(step.value);
      if (performance.now() > end) break;
    }
    setTimeout(() => run(6), 0);
  };
  run(first);
  return () => { stopped = true; };
}
