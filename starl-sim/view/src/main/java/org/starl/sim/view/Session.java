package org.starl.sim.view;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.record.Flight;
import org.starl.sim.record.Part;
import org.starl.sim.record.Scene;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;

/** All that a window shows: a recording, where in it one is, and how it is looked at. */
final class Session {

  /** Real time by which a run may be ahead of the viewer: a few frames. */
  private static final long LEAD_NS = 150_000_000;

  /** Real time during which arrivals are shown, limited in simulated time. */
  private static final long LINGER_NS = 70_000_000;

  private static final long LEAST_LINGER_NS = 15_000_000;
  private static final long MOST_LINGER_NS = 300_000_000;

  private final Recording recording;
  private final ViewSettings settings;
  private final Playback playback;
  private final ViewState view;
  private final Traffic traffic;
  private final Meter meter = new Meter();
  private final @Nullable LiveRun live;

  /**
   * @param recording that has begun
   * @param live the run that fills it; null if it is over, or nobody may do anything to it
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

  /** The run, if a person may do something to it. */
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

  /** Events a second: of the simulation while it goes on, else of what is played. */
  double eventsPerSecond() {
    return meter.perSecond();
  }

  /**
   * Real time goes on.
   *
   * @param realNs of any clock that goes on
   */
  void tick(long realNs, long elapsedNs) {
    if (live != null) {
      live.runUntil(playback.wantedNs(LEAD_NS));
    }
    playback.tick(elapsedNs);
    meter.read(realNs, recording.isOver() ? playback.index() : recording.size());
  }

  /** The datagrams in flight now that are to be shown. */
  List<Flight> flights() {
    if (!view.shows(Part.MESSAGES)) {
      return List.of();
    }
    // While time is stopped, a moment is shown instead of a span.
    double speed = playback.isPlaying() ? Math.min(playback.speed(), 1e3) : 0;
    long lingerNs = (long) Math.max(LEAST_LINGER_NS, Math.min(MOST_LINGER_NS, LINGER_NS * speed));
    return traffic.at(playback.nowNs(), playback.index(), lingerNs, view.selected());
  }

  /** The run's name and seed. */
  String title() {
    var header = recording.header();
    return header.scenario() + ", seed " + header.scenarioSeed();
  }

  /** The latest violation up to the current time; null if there is none. */
  @Nullable Mark violation() {
    return playback.violation();
  }

  @Nullable RobotId selected() {
    return view.selected();
  }
}
