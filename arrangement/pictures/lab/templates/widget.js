// A lab in the cell of a notebook: the page in a frame, whose messages set the trait `state`.
export default {
  render({ model, el }) {
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts allow-downloads");
    frame.style.cssText = "width: 100%; height: 48rem; border: 0";
    frame.srcdoc = model.get("page");
    const listen = (event) => {
      if (event.source !== frame.contentWindow || typeof event.data?.lab !== "string") return;
      model.set("state", event.data.lab);
      model.save_changes();
    };
    addEventListener("message", listen);
    el.append(frame);
    return () => removeEventListener("message", listen);
  },
};
