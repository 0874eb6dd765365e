// Starts the engine while the page itself is still being read.
(globalThis as { basisWorker?: Worker }).basisWorker = new Worker('worker.js');
