package org.starl.apps.lightpaint.logic;

import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;

/**
 * What a painter works on, broadcast so that others choose other strokes. Correctness does not
 * depend on hints: they may be lost, late or wrong.
 *
 * @param stroke its number, or {@link CurrentWork#NONE}
 * @param paints whether the stroke has been assigned to the sender
 * @param finished how many strokes the sender has painted
 */
record Hint(int stroke, boolean paints, int finished) {

  static final Hint INITIAL = new Hint(CurrentWork.NONE, false, 0);

  static final class HintCodec implements Codec<Hint> {
    @Override
    public void write(Hint hint, WireWriter out) {
      out.i32(hint.stroke());
      out.bool(hint.paints());
      out.i32(hint.finished());
    }

    @Override
    public Hint read(WireReader in) {
      Hint hint = new Hint(in.i32(), in.bool(), in.i32());
      if (hint.stroke() < CurrentWork.NONE || hint.finished() < 0) {
        throw new WireFormatException("hint " + hint);
      }
      return hint;
    }
  }
}
