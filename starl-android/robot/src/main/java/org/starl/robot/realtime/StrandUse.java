package org.starl.robot.realtime;

/**
 * How a strand's time was used so far. A long piece keeps every message and timer of its robot
 * waiting.
 *
 * @param pieces how many pieces have run
 * @param heldNs for how long, all together
 * @param medianNs half of the pieces were no longer than this, to a quarter
 * @param p99Ns all but a hundredth were no longer than this, to a quarter
 * @param longestPieceNs the longest of them
 * @param longestBy whose that was: {@code the app}, {@code a timer}, or {@code a message or an event}
 */
public record StrandUse(
    long pieces, long heldNs, long medianNs, long p99Ns, long longestPieceNs, String longestBy) {}
