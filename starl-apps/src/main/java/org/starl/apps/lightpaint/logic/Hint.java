package org.starl.apps.lightpaint.logic;

import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;

/**
 * What a painter is about, told to the others so that they go elsewhere. Nothing rests on it: hints
 * may be lost, late and wrong.
 *
 * @param stroke its number; {@link #NONE} for none
 * @param paints whether the stroke is its own already
 * @param finished how many strokes it has painted
 */
record Hint(int stroke, boolean paints, int finished) {

  static final int NONE = -1;

  static final class HintCodec implements Codec<Hint> {
    @Override
    public void write(Hint hint, WireWriter out) {
      out.i32(hint.stroke());
      out.bool(hint.paints());
      out.i32(hint.finished());
    }

    @Override
    public Hint read(WireReader in) {
      int stroke = in.i32();
      boolean paints = in.bool();
      int finished = in.i32();
      if (stroke < NONE || finished < 0) {
        throw new WireFormatException("stroke " + stroke + ", " + finished + " finished");
      }
      return new Hint(stroke, paints, finished);
    }
  }
}
