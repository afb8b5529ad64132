package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;

/** The work that a painter has in hand, if any, and its note of that. Strand only. */
final class InHand {

  private final List<Stroke> strokes;
  private final Notes notes;
  private final GvhCell<Integer> told;
  private @Nullable Work work;

  InHand(GlobalVarHolder gvh, List<Stroke> strokes) {
    this.strokes = strokes;
    notes = new Notes(gvh.plat.stable);
    told = gvh.variable(PaintTrace.SOURCE, PaintTrace.STROKE, Hint.NONE);
  }

  boolean isNothing() {
    return work == null;
  }

  Work work() {
    if (work == null) {
      throw new IllegalStateException("nothing in hand");
    }
    return work;
  }

  Stroke stroke() {
    return work().stroke();
  }

  /** The stroke's number, {@link Hint#NONE} for nothing. */
  int number() {
    return work == null ? Hint.NONE : work.stroke().number();
  }

  /** Tells the trace which stroke that is. */
  void tell() {
    told.set(number());
  }

  /** Takes what the note says, at the program's start; the painter stands at {@code here}. */
  void resume(Point here) {
    work = notes.read(strokes, here);
  }

  void take(Work next) {
    work = next;
  }

  /** Has nothing in hand any more; the note stays. */
  void letGo() {
    work = null;
  }

  /** The work is somebody else's: has nothing in hand any more, nor in the note. */
  void drop() {
    work = null;
    notes.clear();
  }

  /** The painter, its light on, has come to {@code here}. */
  void painted(Point here) {
    work = work().reached(here);
  }

  void finish() {
    work = work().finished();
  }

  /** Notes how far the work is, where that is worth a note: the painter is at it. */
  void noteProgress() {
    notes.progress(work());
  }

  /**
   * Notes what is in hand.
   *
   * @param isAtWork whether the painter stands where the work goes on, and stays at it
   */
  void note(boolean isAtWork) {
    notes.write(work(), isAtWork);
  }

  /** Whether the note would survive a crash. */
  boolean isNoted() {
    return notes.isSafe();
  }
}
