// The file of the engine as `build.mjs` writes it.
import { decode } from './lzma';
import { join } from './streams';

/** The engine as a module: the file has streams of its parts, each with its length and packed. */
export function unpack(file: ArrayBuffer): Uint8Array<ArrayBuffer> {
  const streams = [];
  for (let at = 0; at < file.byteLength;) {
    const length = new DataView(file).getUint32(at, true);
    streams.push(decode(new Uint8Array(file, at + 4, length)));
    at += 4 + length;
  }
  return join(streams);
}
