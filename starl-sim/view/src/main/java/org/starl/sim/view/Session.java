package org.starl.sim.view;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.Failure;
import org.starl.sim.record.Flight;
import org.starl.sim.record.Part;
import org.starl.sim.record.Scene;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;

/** The state of a window: recording, playback, view and messages. */
final class Session {

  /** Real time that a live run may be ahead of the display: a few pictures. */
  private static final long LEAD_NS = 150_000_000;

  /** Real time for which an arrived message stays visible; limited in simulated time. */
  private static final long LINGER_NS = 70_000_000;

  private static final long LEAST_LINGER_NS = 15_000_000;
  private static final long MOST_LINGER_NS = 300_000_000;

  private final Recording recording;
  private final ViewSettings settings;
  private final Playback playback;
  private final ViewState view;
  private final Traffic traffic;
  private final RateMeter meter = new RateMeter();
  private final @Nullable LiveRun live;
  private boolean hasStopped;

  /**
   * @param recording has begun
   * @param live the run that fills the recording; null for a trace
   */
  Session(Recording recording, @Nullable LiveRun live) {
    this.recording = recording;
    this.live = live;
    settings = ViewSettings.of(recording.header());
    playback = new Playback(recording, settings.speed());
    view = new ViewState(settings.look());
    traffic = new Traffic(recording);
  }

  Recording recording() {
    return recording;
  }

  /** The live run; null after its end, and for a trace. */
  @Nullable LiveRun live() {
    return live == null || live.isOver() ? null : live;
  }

  ViewSettings settings() {
    return settings;
  }

  Playback playback() {
    return playback;
  }

  ViewState view() {
    return view;
  }

  Traffic traffic() {
    return traffic;
  }

  Scene scene() {
    return playback.scene();
  }

  /** Events per real second: of the simulation while it runs, else of the playback. */
  double eventsPerSecond() {
    return meter.perSecond();
  }

  /**
   * Advances by real time.
   *
   * @param realNs time of a monotonic clock
   */
  void tick(long realNs, long elapsedNs) {
    if (live != null) {
      live.runUntil(playback.wantedNs(LEAD_NS));
    }
    playback.tick(elapsedNs);
    stopAtFailure();
    meter.read(realNs, recording.isOver() ? playback.index() : recording.size());
  }

  /**
   * Goes once to what went wrong: in a trace as soon as it is known, in a live run when it comes. That
   * a trace's run did not finish is known before its violations are.
   */
  private void stopAtFailure() {
    Failure failure = recording.wentWrong();
    if (failure != null
        && !hasStopped
        && playback.isPlaying()
        && (failure.kind() != Failure.Kind.UNFINISHED || recording.isChecked())
        && (live == null || playback.nowNs() >= failure.atNs())) {
      hasStopped = true;
      playback.pause();
      playback.seek(failure.atNs());
    }
  }

  /** The visible messages in transit. */
  List<Flight> flights() {
    if (!view.shows(Part.MESSAGES)) {
      return List.of();
    }
    // A paused picture shows one moment, so messages stay visible for the least time.
    double speed = playback.isPlaying() ? Math.min(playback.speed(), 1e3) : 0;
    long lingerNs = (long) Math.max(LEAST_LINGER_NS, Math.min(MOST_LINGER_NS, LINGER_NS * speed));
    return traffic.at(playback.nowNs(), playback.index(), lingerNs, view.selected());
  }

  /** The run's name and seed. */
  String title() {
    var header = recording.header();
    return header.scenario() + ", seed " + header.scenarioSeed();
  }

  /** The latest violation up to the present time; null if there is none. */
  @Nullable Mark violation() {
    return playback.violation();
  }

  @Nullable RobotId selected() {
    return view.selected();
  }
}
