package org.starl.sim.view;

import java.util.List;
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
 * The settings of the window, from a scenario file or {@code --set}; the trace's header keeps them.
 * Also the range of the run's radio. The simulator ignores these settings.
 */
public final class ViewSettings {

  private static final Setting<Double> SPEED =
      Setting.number("speed", 1, "window: simulated seconds per real second; 0 for no limit");
  private static final Setting<Boolean> DRAW_TRAILS =
      Setting.yesOrNo("drawTrails", false, "window: show trails of robots");
  private static final Setting<Integer> TRAIL_LENGTH =
      Setting.whole("trailLength", 128, 1, "window: points of a trail, at most");
  private static final Setting<Boolean> DRAW_WAYPOINTS =
      Setting.yesOrNo("drawWaypoints", true, "window: show the app's drawing, such as waypoints");
  private static final Setting<Boolean> DRAW_OBSTACLES =
      Setting.yesOrNo("drawObstacles", true, "window: show obstacles");
  private static final Setting<Integer> MAX_FPS =
      Setting.whole("maxFps", 30, 1, "window: pictures per real second, at most");

  private static final List<Setting<?>> TABLE =
      List.of(SPEED, DRAW_TRAILS, TRAIL_LENGTH, DRAW_WAYPOINTS, DRAW_OBSTACLES, MAX_FPS);

  private static final Pattern RANGE = Pattern.compile("range\\(([^,)]*)\\)");

  private final SimSettings settings;
  private final double rangeMm;

  private ViewSettings(SimSettings settings, double rangeMm) {
    this.settings = settings;
    this.rangeMm = rangeMm;
  }

  /** The settings of the window, in display order. */
  public static List<Setting<?>> all() {
    return TABLE;
  }

  /** The settings in a run's header; defaults for the others. */
  public static ViewSettings of(TraceHeader header) {
    SimSettings.Builder builder = SimSettings.builder();
    for (Setting<?> setting : TABLE) {
      String value = header.settings().get(setting.key());
      if (value != null) {
        builder.read(setting, value);
      }
    }
    String faults = header.settings().getOrDefault(Setting.FAULTS.key(), "");
    return new ViewSettings(builder.build(), rangeMm(faults));
  }

  /** The distance in a permanent fault {@code range(3m)}; 0 if there is none. */
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

  /** The window's look at the start. */
  public Look look() {
    Look look =
        Look.FILE
            .with(Part.MESSAGES, true)
            .with(Part.RANGE, true)
            .with(Part.LOCATIONS, true)
            .with(Part.TRAILS, settings.get(DRAW_TRAILS))
            .with(Part.WALLS, settings.get(DRAW_OBSTACLES))
            .with(Part.HIDDEN, settings.get(DRAW_OBSTACLES))
            .withTrails(settings.get(TRAIL_LENGTH))
            .withRange(rangeMm);
    return settings.get(DRAW_WAYPOINTS) ? look : look.with(Part.APP, false);
  }

  /** Simulated seconds per real second; 0 for as fast as possible. */
  public static double speed(SimSettings settings) {
    return settings.get(SPEED);
  }

  /** The same; {@link Playback#NO_LIMIT} for as fast as possible. */
  double speed() {
    double speed = speed(settings);
    return speed == 0 ? Playback.NO_LIMIT : speed;
  }

  int maxFps() {
    return settings.get(MAX_FPS);
  }
}
