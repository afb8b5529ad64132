package org.starl.sim.view;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;
import org.starl.sim.replay.Cursor;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;

/**
 * Controls the playback of a recording: plays at some speed, stops, steps, jumps. Used by one
 * thread.
 */
final class Playback {

  /** As fast as possible. */
  static final double NO_LIMIT = Double.POSITIVE_INFINITY;

  /** Simulated seconds in a real one, from slow to fast. */
  static final List<Double> SPEEDS =
      List.of(0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, NO_LIMIT);

  /** So many events at most are gone through between two pictures. */
  private static final int EVENTS_A_TICK = 20_000;

  /** Longer than this a picture does not take; a machine that slept is not to skip a minute. */
  private static final long LONGEST_TICK_NS = 250_000_000;

  private final Recording recording;
  private final Cursor cursor;
  private double speed;
  private boolean isPlaying;

  // Asked for, of a run that has not come so far: a time, or a number of events; else -1.
  private long awaitedNs = -1;
  private int awaitedEvents = -1;

  /**
   * @param speed simulated seconds per real second, above 0; {@link #NO_LIMIT} for no limit
   */
  Playback(Recording recording, double speed) {
    this.recording = recording;
    cursor = new Cursor(recording);
    setSpeed(speed);
  }

  Scene scene() {
    return cursor.scene();
  }

  Layer layer() {
    return cursor.layer();
  }

  long nowNs() {
    return cursor.nowNs();
  }

  /** The number of events before the current time. */
  int index() {
    return cursor.index();
  }

  boolean isPlaying() {
    return isPlaying;
  }

  double speed() {
    return speed;
  }

  /** Whether the current time is the final end of the run. */
  boolean isAtEnd() {
    return recording.isOver() && nowNs() >= recording.endNs();
  }

  /** Plays on from here, or from the beginning if this is the end. */
  void play() {
    if (isAtEnd() && recording.size() > 0) {
      cursor.seek(0);
    }
    awaitedNs = -1;
    awaitedEvents = -1;
    isPlaying = true;
  }

  void pause() {
    isPlaying = false;
  }

  void setSpeed(double newSpeed) {
    if (!(newSpeed > 0)) {
      throw new IllegalArgumentException("speed " + newSpeed + ": expected above 0");
    }
    speed = newSpeed;
  }

  /** To the next of {@link #SPEEDS}, if there is one. */
  void faster() {
    for (double next : SPEEDS) {
      if (next > speed) {
        speed = next;
        return;
      }
    }
  }

  /** To the one before, if there is one. */
  void slower() {
    for (int i = SPEEDS.size() - 1; i >= 0; i--) {
      if (SPEEDS.get(i) < speed) {
        speed = SPEEDS.get(i);
        return;
      }
    }
  }

  /** So much real time has passed. */
  void tick(long elapsedNs) {
    if (!isPlaying) {
      goToAwaited();
      return;
    }
    long furthest = furthestNs();
    if (speed == NO_LIMIT) {
      cursor.seek(Math.max(nowNs(), furthest));
    } else {
      double onNs = Math.min(Math.max(0, elapsedNs), LONGEST_TICK_NS) * speed;
      long wanted = nowNs() + (long) Math.min(onNs, Long.MAX_VALUE / 4.0);
      cursor.seek(Math.max(nowNs(), Math.min(wanted, furthest)));
    }
    if (isAtEnd()) {
      isPlaying = false;
    }
  }

  private void goToAwaited() {
    if (awaitedNs >= 0) {
      cursor.seek(Math.min(awaitedNs, recording.endNs()));
      awaitedNs = isReached(awaitedNs) ? -1 : awaitedNs;
    } else if (awaitedEvents > 0) {
      if (recording.size() >= awaitedEvents) {
        cursor.toEvent(awaitedEvents - 1);
        awaitedEvents = -1;
      } else if (recording.isOver()) {
        seekEnd();
      }
    }
  }

  private boolean isReached(long timeNs) {
    return recording.isOver() || recording.endNs() >= timeNs;
  }

  /**
   * The time that a live run should reach for the requested playback.
   *
   * @param leadNs real time by which the run may be ahead
   */
  long wantedNs(long leadNs) {
    if (isPlaying) {
      return speed == NO_LIMIT ? Long.MAX_VALUE : nowNs() + (long) (leadNs * speed) + 1;
    }
    if (awaitedNs >= 0) {
      return awaitedNs + 1;
    }
    return awaitedEvents > 0 ? recording.endNs() + leadNs : nowNs();
  }

  /** The time at which a tick must end so that the window remains responsive. */
  private long furthestNs() {
    int last = index() + EVENTS_A_TICK;
    return last < recording.size() ? recording.timeNs(last) : recording.endNs();
  }

  /**
   * Jumps to a time, limited to the range from the beginning to the current end. Playing continues
   * there.
   */
  void seek(long timeNs) {
    awaitedNs = -1;
    awaitedEvents = -1;
    cursor.seek(Math.max(0, Math.min(timeNs, recording.endNs())));
  }

  void seekEnd() {
    seek(recording.endNs());
  }

  /** On, or back if below 0; stops playing. */
  void stepTime(long byNs) {
    pause();
    long toNs = nowNs() + byNs;
    seek(toNs);
    awaitedNs = isReached(toNs) ? -1 : toNs;
  }

  /** So many events on, or back if below 0; stops playing. */
  void stepEvents(int by) {
    pause();
    int number = index() - 1 + by;
    if (number < 0) {
      cursor.seek(0);
      if (recording.size() > 0 && index() > 0) {
        // Several may happen at time 0.
        cursor.toEvent(0);
      }
    } else if (number < recording.size()) {
      cursor.toEvent(number);
    } else {
      seekEnd();
      awaitedEvents = recording.isOver() ? -1 : number + 1;
    }
  }

  /** Jumps to a mark of the timeline and stops playing. */
  void toMark(Mark mark) {
    pause();
    awaitedNs = -1;
    awaitedEvents = -1;
    cursor.toEvent(mark.index());
  }

  /**
   * The nearest mark after or before the current time.
   *
   * @param kind the kind of mark, or null for any
   * @return null if there is none
   */
  @Nullable Mark neighbour(boolean isAfter, Mark.@Nullable Kind kind) {
    Mark best = null;
    for (Mark mark : recording.marks()) {
      boolean isWanted = kind == null || kind == mark.kind();
      boolean isBeyond = isAfter ? mark.index() >= index() : mark.index() < index() - 1;
      if (isWanted && isBeyond && (best == null || isNearer(mark, best, isAfter))) {
        best = mark;
      }
    }
    return best;
  }

  private static boolean isNearer(Mark mark, Mark best, boolean isAfter) {
    return isAfter ? mark.index() < best.index() : mark.index() > best.index();
  }

  /** The latest violation up to the current time; null if there is none. */
  @Nullable Mark violation() {
    Mark latest = null;
    for (Mark mark : recording.marks()) {
      if (mark.kind() == Mark.Kind.VIOLATION && mark.index() < index()) {
        latest = mark;
      }
    }
    return latest;
  }
}
