package org.starl.apps.lightpaint.logic;

import static org.starl.shape.Shapes.BOOL;
import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.part;

import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * What a painter works on, broadcast so that others choose other strokes. Correctness does not
 * depend on hints: they may be lost, late or wrong.
 *
 * @param stroke its number, or {@link CurrentWork#NONE}
 * @param paints whether the stroke has been assigned to the sender
 * @param finished how many strokes the sender has painted
 */
record Hint(int stroke, boolean paints, int finished) {

  /** The shape of hints. */
  static final Shape<Hint> SHAPE =
      Shapes.of(
          Hint.class,
          part("stroke", INT, Hint::stroke),
          part("paints", BOOL, Hint::paints),
          part("finished", INT, Hint::finished),
          Hint::new);

  static final Hint INITIAL = new Hint(CurrentWork.NONE, false, 0);

  Hint {
    if (stroke < CurrentWork.NONE || finished < 0) {
      throw new IllegalArgumentException(
          "hint of stroke " + stroke + ", " + finished + " finished");
    }
  }
}
