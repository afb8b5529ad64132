package org.starl.sim.net;

import org.starl.id.RobotId;
import org.starl.random.Rng;

/**
 * One copy of a datagram on its way to one recipient, as rules and choices see it.
 *
 * @param sentAtNs when it was handed to the radio
 * @param datagram its number among the sender's datagrams of this run, from 0; the copies of a
 *     broadcast share it
 * @param bytes its length
 * @param rng a generator for this copy alone: draws from it change no other copy
 */
public record Transmission(
    RobotId from, RobotId to, long sentAtNs, long datagram, int bytes, Rng rng) {}
