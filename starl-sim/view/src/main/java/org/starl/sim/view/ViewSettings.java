package org.starl.sim.view;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.record.Look;
import org.starl.sim.record.Part;
import org.starl.trace.TraceHeader;

/**
 * What a run's settings say about its window: {@code speed}, {@code drawTrails}, {@code trailLength},
 * {@code drawWaypoints}, {@code drawWaypointNames}, {@code drawObstacles}, {@code maxFps}; and how far
 * its radio reaches.
 */
final class ViewSettings {

  private static final Pattern RANGE = Pattern.compile("range\\(([^,)]*)\\)");

  private final SimSettings settings;
  private final double rangeMm;

  private ViewSettings(SimSettings settings, double rangeMm) {
    this.settings = settings;
    this.rangeMm = rangeMm;
  }

  /** Of a run: what its header says, else the defaults. */
  static ViewSettings of(TraceHeader header) {
    SimSettings.Builder builder = SimSettings.builder();
    for (Setting<?> setting : Setting.all()) {
      String value = header.settings().get(setting.key());
      if (value != null && isOfWindow(setting)) {
        builder.set(setting.key(), value);
      }
    }
    String faults = header.settings().getOrDefault(Setting.FAULTS.key(), "");
    return new ViewSettings(builder.build(), rangeMm(faults));
  }

  private static boolean isOfWindow(Setting<?> setting) {
    return setting == Setting.SPEED
        || setting == Setting.DRAW_TRAILS
        || setting == Setting.TRAIL_LENGTH
        || setting == Setting.DRAW_WAYPOINTS
        || setting == Setting.DRAW_WAYPOINT_NAMES
        || setting == Setting.DRAW_OBSTACLES
        || setting == Setting.MAX_FPS;
  }

  /** Of {@code range(3m)} among faults that last all the time; 0 if there is none. */
  private static double rangeMm(String faults) {
    Matcher range = RANGE.matcher(faults);
    if (!range.find()) {
      return 0;
    }
    try {
      return Quantities.distanceMm(range.group(1));
    } catch (BadInput notAlone) {
      return 0;
    }
  }

  /** What is switched on at first. */
  Look look() {
    Look look =
        Look.FILE
            .with(Part.MESSAGES, true)
            .with(Part.RANGE, true)
            .with(Part.LOCATIONS, true)
            .with(Part.TRAILS, settings.get(Setting.DRAW_TRAILS))
            .with(Part.WALLS, settings.get(Setting.DRAW_OBSTACLES))
            .with(Part.HIDDEN, settings.get(Setting.DRAW_OBSTACLES))
            .withTrails(settings.get(Setting.TRAIL_LENGTH))
            .withRange(rangeMm);
    return settings.get(Setting.DRAW_WAYPOINTS) ? look : look.with(Part.APP, false);
  }

  /** Simulated seconds in a real one; {@link Playback#NO_LIMIT} for as fast as it goes. */
  double speed() {
    double speed = settings.get(Setting.SPEED);
    return speed == 0 ? Playback.NO_LIMIT : speed;
  }

  int maxFps() {
    return settings.get(Setting.MAX_FPS);
  }
}
