/** Bytes of all files of the page together, each compressed with gzip: what it may not grow beyond, 700 KiB. */
export const BUDGET = 700 * 1024;
