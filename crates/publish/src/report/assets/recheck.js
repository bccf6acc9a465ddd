// The second verifier, in a worker where there is one, else in the page.

// Runs a function of the verifier's source, the constant VERIFIER, on a certificate, in a worker where there is one, else here.
function recheck(certificate, run = "verify") {
  const url = (text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  const here = async () => (await import(url(VERIFIER)))[run](certificate);
  return new Promise((resolve, reject) => {
    let worker;
    const instead = () => { worker?.terminate(); here().then(resolve, reject); };
    try {
      const listen = `\nonmessage = (e) => { try { postMessage({ answer: ${run}(e.data) }); }
        catch (error) { postMessage({ failure: String(error) }); } };\n`;
      // A page that is a file may start scripts from memory, but no modules.
      worker = new Worker(url(VERIFIER.replace(/^export .*$/gm, "") + listen));
    } catch {
      return instead();
    }
    worker.onerror = instead;
    worker.onmessage = ({ data }) => {
      worker.terminate();
      if (data.failure) reject(new Error(data.failure));
      else resolve(data.answer);
    };
    worker.postMessage(certificate);
  });
}

const counted = (count, one, many) => `${count} ${count === 1 ? one : many}`;
