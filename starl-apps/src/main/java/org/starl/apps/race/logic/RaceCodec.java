package org.starl.apps.race.logic;

import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;

/** The bytes of {@link RaceMessage}s: a kind, and of a claim its point, winner, time and distance. */
final class RaceCodec implements Codec<RaceMessage> {

  private static final int CLAIM = 1;
  private static final int QUESTION = 2;

  private final int points;

  /**
   * @param points of the race: no claim is on another one
   */
  RaceCodec(int points) {
    this.points = points;
  }

  @Override
  public void write(RaceMessage message, WireWriter out) {
    switch (message) {
      case Claim claim -> {
        out.u8(CLAIM);
        out.u16(claim.point());
        out.robot(claim.winner());
        out.i64(claim.atNs());
        out.i32(claim.keptOffMm());
      }
      case RaceMessage.Question question -> out.u8(QUESTION);
    }
  }

  @Override
  public RaceMessage read(WireReader in) {
    int kind = in.u8();
    return switch (kind) {
      case CLAIM -> new Claim(point(in), in.robot(), in.i64(), in.i32());
      case QUESTION -> new RaceMessage.Question();
      default -> throw new WireFormatException("race message of kind " + kind);
    };
  }

  private int point(WireReader in) {
    int point = in.u16();
    if (point >= points) {
      throw new WireFormatException("point " + point + " of a race of " + points);
    }
    return point;
  }
}
