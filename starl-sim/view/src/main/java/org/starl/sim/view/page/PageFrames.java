package org.starl.sim.view.page;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import org.starl.id.RobotId;
import org.starl.sim.record.Flight;
import org.starl.sim.record.LanePainter;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Painter.Section;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.sim.record.Viewport;
import org.starl.sim.view.Inspection;

/**
 * The pictures of a page. The painter of the window draws each section of a picture twice, in the
 * light and in the dark theme; both have the same shapes, so each item has two colours.
 */
final class PageFrames {

  /** Kinds of items besides {@link DrawnItem}'s: they begin with the number of a robot's name. */
  private static final int IF_SELECTED = 6;

  private static final int BODY = 7;
  private static final int STATE = 8;

  private static final int UNITS_PER_PX = 10;

  private final Painter painter = Painter.ofShapes();
  private final Viewport viewport;
  private final Look look;
  private final Map<String, Integer> texts = new LinkedHashMap<>();
  private final Map<List<String>, Integer> styles = new LinkedHashMap<>();
  private final List<FrameEncoder> encoders = new ArrayList<>();
  private final List<List<List<Object>>> frames = new ArrayList<>();

  PageFrames(Viewport viewport, Look look) {
    this.viewport = viewport;
    this.look = look;
    for (int i = 0; i < Section.values().length + 2; i++) {
      encoders.add(new FrameEncoder());
    }
  }

  /** Distinct texts, by number. */
  List<String> texts() {
    return List.copyOf(texts.keySet());
  }

  /** Distinct styles, by number: colour in the light and in the dark theme, pen. */
  List<List<String>> styles() {
    return List.copyOf(styles.keySet());
  }

  /** For each picture its sections, then bodies and states of robots; see {@link FrameEncoder}. */
  List<List<List<Object>>> frames() {
    return List.copyOf(frames);
  }

  int size() {
    return frames.size();
  }

  /** The pictures since the last call, which {@link #frames} then lacks. */
  List<List<List<Object>>> takeFrames() {
    List<List<List<Object>>> taken = frames();
    frames.clear();
    return taken;
  }

  /** Adds the picture of a moment. */
  void add(Scene scene, Layer layer, List<Flight> messages) {
    List<List<int[]>> parts = new ArrayList<>();
    for (Section section : Section.values()) {
      parts.add(
          section == Section.SELECTION
              ? selections(scene, layer)
              : drawn(section, scene, layer, look, messages));
    }
    parts.add(bodies(scene, layer));
    parts.add(states(scene));
    List<List<Object>> frame = new ArrayList<>();
    for (int i = 0; i < parts.size(); i++) {
      frame.add(encoders.get(i).next(parts.get(i)));
    }
    frames.add(frame);
  }

  private List<int[]> drawn(
      Section section, Scene scene, Layer layer, Look wanted, List<Flight> messages) {
    return drawn((page, theme) ->
        painter.paint(section, page, scene, layer, viewport, wanted.in(theme), messages));
  }

  /** The lanes of each robot: its name, their height, and their items. */
  List<List<Object>> lanes(LanePainter lanes) {
    List<List<Object>> all = new ArrayList<>();
    for (RobotId robot : lanes.lanes().robots()) {
      all.add(
          List.of(
              text(robot.name()),
              lanes.heightPx(robot),
              drawn((page, theme) -> lanes.paint(page, robot, theme))));
    }
    return all;
  }

  private List<int[]> drawn(BiConsumer<Graphics2D, Theme> painting) {
    List<DrawnItem> light = new ArrayList<>();
    List<DrawnItem> dark = new ArrayList<>();
    painting.accept(new ShapeRecorder(light), Theme.LIGHT);
    painting.accept(new ShapeRecorder(dark), Theme.DARK);
    List<int[]> items = new ArrayList<>();
    for (int i = 0; i < light.size(); i++) {
      DrawnItem item = light.get(i);
      // An app may draw other shapes in the dark: then both themes show the light ones.
      boolean isSame = dark.size() == light.size() && dark.get(i).isSameShape(item);
      items.add(numbers(item, isSame ? dark.get(i).rgba() : item.rgba()));
    }
    return items;
  }

  private int[] numbers(DrawnItem item, int darkRgba) {
    int style = style(item.rgba(), darkRgba, item.pen().text());
    int[] own = item.numbers();
    boolean hasText = !item.text().isEmpty();
    int[] all = new int[own.length + (hasText ? 3 : 2)];
    all[0] = item.kind();
    all[1] = style;
    if (hasText) {
      all[2] = text(item.text());
    }
    System.arraycopy(own, 0, all, all.length - own.length, own.length);
    return all;
  }

  private int style(int lightRgba, int darkRgba, String pen) {
    return styles.computeIfAbsent(
        List.of(css(lightRgba), css(darkRgba), pen), style -> styles.size());
  }

  /** A colour in the syntax of CSS: {@code #rrggbbaa}. */
  static String css(int rgba) {
    return String.format("#%06x%02x", rgba & 0xFFFFFF, rgba >>> 24);
  }

  private int text(String text) {
    return texts.computeIfAbsent(text, any -> texts.size());
  }

  /** What selecting each robot adds. */
  private List<int[]> selections(Scene scene, Layer layer) {
    List<int[]> all = new ArrayList<>();
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      List<int[]> ring = drawn(Section.SELECTION, scene, layer, look.about(robot), List.of());
      all.add(new int[] {IF_SELECTED, text(robot.name()), ring.size()});
      all.addAll(ring);
    });
    return all;
  }

  /** Colour, description, radius and place of each robot on the floor. */
  private List<int[]> bodies(Scene scene, Layer layer) {
    List<int[]> all = new ArrayList<>();
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      Color dark = Theme.DARK.robot(number);
      all.add(
          new int[] {
            BODY,
            text(robot.name()),
            style(Theme.LIGHT.robot(number).getRGB(), dark.getRGB(), ""),
            text(layer.describe(robot, scene).replace("\n", "; ")),
            units(radiusMm * viewport.pxPerMm()),
            units(viewport.xPx(pose.at())),
            units(viewport.yPx(pose.at()))
          });
    });
    return all;
  }

  /** Variables of each robot, as the window's inspector shows them; -1 follows a title. */
  private List<int[]> states(Scene scene) {
    List<int[]> all = new ArrayList<>();
    for (RobotId robot : scene.robots()) {
      List<Inspection.Row> rows = Inspection.state(scene, robot);
      int[] state = new int[2 + 2 * rows.size()];
      state[0] = STATE;
      state[1] = text(robot.name());
      for (int i = 0; i < rows.size(); i++) {
        state[2 + 2 * i] = text(rows.get(i).name());
        state[3 + 2 * i] = rows.get(i).isTitle() ? -1 : text(rows.get(i).value());
      }
      all.add(state);
    }
    return all;
  }

  private static int units(double px) {
    return (int) Math.round(UNITS_PER_PX * px);
  }
}
