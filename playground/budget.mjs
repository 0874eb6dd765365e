/** Bytes of all files of the page together, each compressed with gzip: what it may not grow beyond, 0.7 MB. */
export const BUDGET = 700_000;
