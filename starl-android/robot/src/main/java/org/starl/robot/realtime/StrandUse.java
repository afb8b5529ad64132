package org.starl.robot.realtime;

/**
 * The use of a strand's time. A long piece delays every message and timer of its robot.
 *
 * @param pieces number of pieces
 * @param heldNs their total length
 * @param medianNs median length, at most a quarter too long
 * @param p99Ns 99th percentile of the lengths, at most a quarter too long
 * @param longestPieceNs length of the longest
 * @param longestBy its origin: {@code the app}, {@code a timer}, or {@code a message or an event}
 */
public record StrandUse(
    long pieces, long heldNs, long medianNs, long p99Ns, long longestPieceNs, String longestBy) {}
