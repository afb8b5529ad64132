package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.geometry.Point;
import org.starl.gvh.GvhCell;
import org.starl.platform.StableStorage;

/**
 * The stroke that a painter works on, if any, and the note of it on stable storage: after a restart
 * the painter continues from the note. Strand only.
 */
final class CurrentWork {

  /** {@link #number} while there is no work. */
  static final int NONE = -1;

  private static final String KEY = "lightpaint/work";
  private static final int NOTE_BYTES = 14;
  private static final double NOTE_EVERY_MM = 10;

  private final List<Stroke> strokes;
  private final StableStorage stable;
  private final GvhCell<Integer> tracedNumber;
  private @Nullable Work work;
  private double notedMm = -NOTE_EVERY_MM;
  private int unflushedNotes;

  CurrentWork(GlobalVarHolder gvh, List<Stroke> strokes) {
    this.strokes = strokes;
    stable = gvh.plat.stable;
    tracedNumber = gvh.variable(PaintTrace.SOURCE, PaintTrace.STROKE, NONE);
  }

  boolean isNone() {
    return work == null;
  }

  Work get() {
    if (work == null) {
      throw new IllegalStateException("no stroke to work on");
    }
    return work;
  }

  Stroke stroke() {
    return get().stroke();
  }

  /** The stroke's number, or {@link #NONE}. */
  int number() {
    return work == null ? NONE : work.stroke().number();
  }

  void traceNumber() {
    tracedNumber.set(number());
  }

  void set(Work next) {
    work = next;
  }

  /** Ends the work; the note stays. */
  void clear() {
    work = null;
  }

  /** Ends the work and erases the note: the stroke belongs to another painter. */
  void drop() {
    work = null;
    notedMm = -NOTE_EVERY_MM;
    put(new byte[0]);
  }

  /** Records that the painter, with its light on, has come to {@code here}. */
  void paintedTo(Point here) {
    work = get().paintedTo(here);
  }

  void finish() {
    work = get().finished();
  }

  /** Writes the note if the painter, which is painting, has come 10 mm farther than the note says. */
  void noteProgress() {
    if (get().doneMm() >= notedMm + NOTE_EVERY_MM) {
      note(true);
    }
  }

  /**
   * Writes the note.
   *
   * @param isAtWork whether the painter stays on the stroke, where the work continues
   */
  void note(boolean isAtWork) {
    byte[] bytes = new byte[NOTE_BYTES];
    WireWriter out = new WireWriter(bytes);
    out.i32(number());
    out.bool(get().isReversed());
    out.f64(get().doneMm());
    out.bool(isAtWork);
    notedMm = get().doneMm();
    put(bytes);
  }

  /** Whether the latest note would survive a crash. */
  boolean isNoted() {
    return unflushedNotes == 0;
  }

  private void put(byte[] bytes) {
    unflushedNotes++;
    stable.put(KEY, bytes, () -> unflushedNotes--);
  }

  /**
   * Reads the note at the start of the program.
   *
   * @param here where the painter stands: if it was painting, this tells its progress more exactly
   *     than the note
   */
  void resume(Point here) {
    byte[] bytes = stable.get(KEY);
    if (bytes == null || bytes.length == 0) {
      return;
    }
    WireReader in = new WireReader(bytes);
    Stroke stroke = strokes.get(in.i32());
    boolean isReversed = in.bool();
    Work noted = Work.of(stroke, isReversed, in.f64());
    work = in.bool() ? noted.paintedTo(here) : noted;
  }
}
