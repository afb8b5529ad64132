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
 * @param awayMm how far it was from the stroke when it sent this
 */
record Hint(int stroke, boolean paints, int finished, int awayMm) {

  /** The shape of hints. */
  static final Shape<Hint> SHAPE =
      Shapes.of(
          Hint.class,
          part("stroke", INT, Hint::stroke),
          part("paints", BOOL, Hint::paints),
          part("finished", INT, Hint::finished),
          part("awayMm", INT, Hint::awayMm),
          Hint::new);

  static final Hint INITIAL = new Hint(CurrentWork.NONE, false, 0, 0);

  Hint {
    if (stroke < CurrentWork.NONE || finished < 0 || awayMm < 0) {
      throw new IllegalArgumentException(
          "hint of stroke " + stroke + ", " + finished + " finished, " + awayMm + " mm away");
    }
  }

  /** Whether it tells of the same work. */
  boolean isLike(Hint other) {
    return stroke == other.stroke && paints == other.paints && finished == other.finished;
  }
}
