package org.starl.trace;

/**
 * The last line of a complete trace.
 *
 * @param timeNs end of the run, in ns from its start
 * @param events number of events in the trace
 */
public record TraceEnd(long timeNs, long events) {}
