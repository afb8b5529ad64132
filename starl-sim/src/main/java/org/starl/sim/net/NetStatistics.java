package org.starl.sim.net;

/**
 * What the air has carried so far.
 *
 * @param sent datagrams handed to radios; a broadcast is one
 * @param sentBytes their lengths added up
 * @param delivered copies handed to a recipient's radio
 * @param lost copies that came to nothing: loss, a rule, a recipient that does not exist or is gone
 */
public record NetStatistics(long sent, long sentBytes, long delivered, long lost) {}
