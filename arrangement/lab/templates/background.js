// Runs a generator a few milliseconds at a time, so that dragging never stutters; `done` takes what it
// returns. Returns what stops it.
function inSlices(search, done, first = 12) {
  let stopped = false;
  const run = (budget) => {
    if (stopped) return;
    const end = performance.now() + budget;
    for (;;) {
      const step = search.next();
      if (step.done) { done(step.value); return; }
      if (performance.now() > end) break;
    }
    setTimeout(() => run(6), 0);
  };
  run(first);
  return () => { stopped = true; };
}
