package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.geometry.Point;
import org.starl.platform.Stable;

/** What a painter must know after a restart: which stroke it has in hand, and how far it is. */
final class Notes {

  private static final String KEY = "lightpaint/work";
  private static final int BYTES = 14;
  private static final double STEP_MM = 10;

  private final Stable stable;
  private double notedMm = -STEP_MM;
  private int unflushed;

  Notes(Stable stable) {
    this.stable = stable;
  }

  /**
   * What was in hand, or null for nothing.
   *
   * @param here where the robot stands: if it was at work, that tells better than the note how far it
   *     has come
   */
  @Nullable Work read(List<Stroke> strokes, Point here) {
    byte[] bytes = stable.get(KEY);
    if (bytes == null || bytes.length == 0) {
      return null;
    }
    WireReader in = new WireReader(bytes);
    Stroke stroke = strokes.get(in.i32());
    boolean isReversed = in.bool();
    Work work = Work.of(stroke, isReversed, in.f64());
    return in.bool() ? work.reached(here) : work;
  }

  /** Notes how far the work is; what is hardly farther than noted before need not be noted. */
  void progress(Work work) {
    if (work.doneMm() >= notedMm + STEP_MM) {
      write(work, true);
    }
  }

  /**
   * Notes all of it.
   *
   * @param isAtWork whether the robot stands where the work goes on, and stays at it
   */
  void write(Work work, boolean isAtWork) {
    byte[] bytes = new byte[BYTES];
    WireWriter out = new WireWriter(bytes);
    out.i32(work.stroke().number());
    out.bool(work.isReversed());
    out.f64(work.doneMm());
    out.bool(isAtWork);
    notedMm = work.doneMm();
    put(bytes);
  }

  void clear() {
    notedMm = -STEP_MM;
    put(new byte[0]);
  }

  /** Whether all that was written would survive a crash. */
  boolean isSafe() {
    return unflushed == 0;
  }

  private void put(byte[] bytes) {
    unflushed++;
    stable.put(KEY, bytes, () -> unflushed--);
  }
}
