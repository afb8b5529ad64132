package org.starl.apps.race.logic;

import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;

/** A message between the robots of a race. */
sealed interface RaceMessage permits Claim, RaceMessage.Question {

  /** From a robot that has (re)started and knows no winners: which points are won? */
  record Question() implements RaceMessage {}

  /**
   * The bytes of messages: the kind (u8), and of a claim its point (u16), winner, time (i64) and
   * distance (i32).
   *
   * @param points of the race: claims on other points are refused
   */
  record Wire(int points) implements Codec<RaceMessage> {

    private static final int CLAIM = 1;
    private static final int QUESTION = 2;

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
        case Question question -> out.u8(QUESTION);
      }
    }

    @Override
    public RaceMessage read(WireReader in) {
      int kind = in.u8();
      return switch (kind) {
        case CLAIM -> new Claim(point(in), in.robot(), in.i64(), in.i32());
        case QUESTION -> new Question();
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
}
