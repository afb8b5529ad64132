package org.starl.sim.net;

/**
 * Counts of the network so far.
 *
 * @param sent datagrams handed to radios; a broadcast is one
 * @param sentBytes the sum of their lengths
 * @param delivered copies handed to a recipient's radio
 * @param lost copies not delivered: by loss, by a rule, or because the recipient has no radio
 */
public record NetStatistics(long sent, long sentBytes, long delivered, long lost) {}
