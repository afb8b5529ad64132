package org.starl.deploy.realtime;

/**
 * How a strand's time was used so far. A long piece keeps every message and timer of its robot
 * waiting.
 *
 * @param pieces how many pieces have run
 * @param heldNs for how long, all together
 * @param longestPieceNs the longest of them
 */
public record StrandUse(long pieces, long heldNs, long longestPieceNs) {

  static final StrandUse NONE = new StrandUse(0, 0, 0);

  StrandUse plus(long pieceNs) {
    return new StrandUse(pieces + 1, heldNs + pieceNs, Math.max(longestPieceNs, pieceNs));
  }
}
