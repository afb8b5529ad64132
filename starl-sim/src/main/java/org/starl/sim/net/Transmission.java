package org.starl.sim.net;

import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * One copy of a datagram in flight to one recipient, as rules and choices see it.
 *
 * @param sentAtNs the time at which the radio sent it
 * @param datagram its number among the sender's datagrams of this run, from 0; the copies of a
 *     broadcast share it
 * @param rng a generator for this copy only: draws from it do not affect other copies
 */
public record Transmission(RobotId from, RobotId to, long sentAtNs, long datagram, Rng rng) {}
