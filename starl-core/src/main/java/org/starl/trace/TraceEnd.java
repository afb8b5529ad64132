package org.starl.trace;

/**
 * The last line of a trace that was written whole.
 *
 * @param timeNs when the run ended, in ns from its start
 * @param events how many events stand between header and end
 */
public record TraceEnd(long timeNs, long events) {}
