package org.starl.sim.replay;

import org.jspecify.annotations.Nullable;

/**
 * The hand of a clock that goes through a recording: at some speed, or as fast as the run goes, or not
 * at all. Of a run that is live it says how far that may go on: a little ahead of what is shown. It knows
 * no clock itself: whoever shows the recording calls {@link #tick} for each picture. One thread's own.
 */
public final class Player {

  /** The slowest speed: a tenth of real time. */
  public static final double SLOWEST = 0.1;

  /** No speed: as fast as the run goes, and of a run that is over, to its end. */
  public static final double FASTEST = Double.POSITIVE_INFINITY;

  private static final double LEAD_NS = 150e6;

  private final Recording recording;
  private final @Nullable LiveRun live;
  private double speed = 1;
  private boolean isPlaying;
  private long nowNs;
  private long wallNs;
  private boolean hasTicked;

  /** Stands at the beginning and does not play. */
  public Player(Recording recording) {
    this(recording, null);
  }

  /** The same, of a run that is live. */
  public Player(Recording recording, @Nullable LiveRun live) {
    this.recording = recording;
    this.live = live;
  }

  public void play() {
    isPlaying = true;
  }

  public void pause() {
    isPlaying = false;
  }

  public boolean isPlaying() {
    return isPlaying;
  }

  /**
   * So many seconds of the run a second.
   *
   * @param newSpeed {@link #SLOWEST} to {@link #FASTEST}
   */
  public void setSpeed(double newSpeed) {
    if (!(newSpeed >= SLOWEST)) {
      throw new IllegalArgumentException("speed " + newSpeed + ": expected at least " + SLOWEST);
    }
    speed = newSpeed;
  }

  public double speed() {
    return speed;
  }

  /** Goes to that time of the run, and on from there if it plays. */
  public void seek(long timeNs) {
    nowNs = Math.max(0, Math.min(timeNs, recording.endNs()));
    lead();
  }

  /** Whether it stands at the end of a run that is over. */
  public boolean isAtEnd() {
    return recording.isOver() && nowNs >= recording.endNs();
  }

  /**
   * Time goes on, if it plays; no farther than the run has come.
   *
   * @param newWallNs of any clock that shows real time, not before the last one
   * @return the time of the run to show
   */
  public long tick(long newWallNs) {
    long passedNs = hasTicked ? newWallNs - wallNs : 0;
    wallNs = newWallNs;
    hasTicked = true;
    if (isPlaying) {
      long endNs = recording.endNs();
      double wantedNs = speed == FASTEST ? endNs : nowNs + passedNs * speed;
      nowNs = wantedNs >= endNs ? Math.max(endNs, nowNs) : (long) wantedNs;
    }
    lead();
    return nowNs;
  }

  /** The time of the run to show. */
  public long nowNs() {
    return nowNs;
  }

  private void lead() {
    if (live != null) {
      boolean isFree = isPlaying && speed == FASTEST;
      live.runUntil(
          isFree ? Long.MAX_VALUE : (long) (nowNs + LEAD_NS * Math.max(1, isPlaying ? speed : 1)));
    }
  }
}
