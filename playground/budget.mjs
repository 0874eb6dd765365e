/** Bytes of all files of the page together, each compressed with gzip: what it may not grow beyond. */
export const BUDGET = 700_000;
