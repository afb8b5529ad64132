package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.starl.LightColour;
import org.starl.LightControl;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.time.Time;

/**
 * Paints a {@link Scene} with its {@link Layer}, for the window and for files. Objects outside the
 * picture cost little, and many robots are painted with cached sprites. Not thread-safe.
 */
public final class Painter {

  /**
   * More visible robots than {@code MANY}, if smaller than {@code LARGE_PX}, are painted with
   * sprites.
   */
  private static final int MANY = 250;

  private static final double LARGE_PX = 40;
  private static final double LIGHT_RADII = 1.5;
  private static final int LIGHT_ALPHA = 110;
  private static final double SPECK_PX = 1.5;
  private static final long BUMP_SHOWN_NS = 10 * Time.NS_PER_S;

  private final BodyPainter bodies = new BodyPainter();
  private final Sprites sprites = new Sprites();
  private final ObstaclePainter obstacles;
  private final int most;
  private final TrailPainter trails = new TrailPainter();
  private final FlightPainter flights = new FlightPainter();

  /** A section of a picture, from back to front. */
  public enum Section {
    /** The app's drawing under the bodies, and the robots' lights. */
    FLOOR,
    OBSTACLES,
    /** The zone and the robots of what went wrong. */
    FAILURE,
    TRAILS,
    ROBOTS,
    /** Where robots wrongly believe to be. */
    BELIEFS,
    /** The ring around the selected robot, and the range of its radio. */
    SELECTION,
    /** The app's drawing over the bodies. */
    OVER,
    BUMPS,
    MESSAGES,
    LABELS
  }

  /** Whether what lies outside of the viewport is left out. */
  private final boolean isCut;

  /** For the screen and for pictures: with cached images of many obstacles or robots. */
  public Painter() {
    this(true);
  }

  private Painter(boolean hasCaches) {
    isCut = hasCaches;
    obstacles = new ObstaclePainter(hasCaches);
    most = hasCaches ? MANY : Integer.MAX_VALUE;
  }

  /** For drawings that are enlarged later: paints shapes, never images. */
  public static Painter ofShapes() {
    return new Painter(false);
  }

  /** Paints without messages. */
  public void paint(Graphics2D page, Scene scene, Layer layer, Viewport viewport, Look look) {
    paint(page, scene, layer, viewport, look, List.of());
  }

  /**
   * Paints the whole viewport, background included.
   *
   * @param page its origin is the viewport's upper left corner
   * @param messages in transit, or just arrived
   */
  public void paint(
      Graphics2D page,
      Scene scene,
      Layer layer,
      Viewport viewport,
      Look look,
      List<Flight> messages) {
    smooth(page);
    page.setColor(look.theme().paper());
    page.fillRect(0, 0, viewport.widthPx(), viewport.heightPx());
    for (Section section : Section.values()) {
      paint(section, page, scene, layer, viewport, look, messages);
    }
  }

  /** Paints one section, if {@code look} shows it, on what is there. */
  public void paint(
      Section section,
      Graphics2D page,
      Scene scene,
      Layer layer,
      Viewport viewport,
      Look look,
      List<Flight> messages) {
    switch (section) {
      case FLOOR -> {
        app(page, viewport, look, floor -> layer.paintFloor(floor, scene, look.at(viewport)));
        lights(page, scene, viewport, look);
      }
      case OBSTACLES -> obstacles.paint(page, scene, viewport, look.at(viewport));
      case FAILURE -> FailurePainter.paint(page, scene, viewport, look.theme());
      case TRAILS -> {
        if (look.shows(Part.TRAILS) && layer.showsTrails()) {
          trails.paint(page, scene, viewport, look);
        }
      }
      case ROBOTS -> {
        if (look.shows(Part.ROBOTS)) {
          robots(page, scene, viewport, look);
        }
      }
      case BELIEFS -> {
        if (look.shows(Part.BELIEFS)) {
          FailurePainter.paintBeliefs(page, scene, viewport, look);
        }
      }
      case SELECTION -> selection(page, scene, viewport, look);
      case OVER ->
          app(page, viewport, look, floor -> layer.paintOver(floor, scene, look.at(viewport)));
      case BUMPS -> {
        if (look.shows(Part.BUMPS)) {
          bumps(page, scene, viewport, look.theme());
        }
      }
      case MESSAGES -> {
        if (look.shows(Part.MESSAGES)) {
          flights.paint(page, messages, scene, viewport, look);
        }
      }
      case LABELS -> Labels.paint(page, scene, viewport, look, isCut);
    }
  }

  /** Lets the app paint, in the world's coordinates. */
  private static void app(
      Graphics2D page, Viewport viewport, Look look, Consumer<Graphics2D> drawing) {
    if (look.shows(Part.APP)) {
      Graphics2D floor = (Graphics2D) page.create();
      floor.transform(viewport.transform());
      drawing.accept(floor);
      floor.dispose();
    }
  }

  /** Turns antialiasing on, for shapes and text. */
  public static void smooth(Graphics2D page) {
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    page.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
  }

  /** Draws a diagonal cross. */
  public static void cross(Graphics2D page, double x, double y, double arm) {
    page.draw(new Line2D.Double(x - arm, y - arm, x + arm, y + arm));
    page.draw(new Line2D.Double(x - arm, y + arm, x + arm, y - arm));
  }

  /** Paints a disc of its colour around each robot whose light is on. */
  private void lights(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    if (!look.shows(Part.ROBOTS)) {
      return;
    }
    Theme theme = look.theme();
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      LightColour colour = scene.variable(robot, LightControl.SOURCE, LightControl.COLOUR);
      if (colour != null
          && !colour.equals(LightColour.OFF)
          && isShown(viewport, pose.at(), LIGHT_RADII * radiusMm)) {
        double radiusPx = LIGHT_RADII * radiusMm * viewport.pxPerMm();
        page.setColor(Theme.faded(theme.visible(new Color(colour.rgb())), LIGHT_ALPHA));
        page.fill(Figures.disc(viewport.xPx(pose.at()), viewport.yPx(pose.at()), radiusPx));
      }
    });
  }

  private boolean isShown(Viewport viewport, Point at, double radiusMm) {
    return !isCut || viewport.shows(at, radiusMm);
  }

  /** Paints the bodies, and marks crashed ones. */
  private void robots(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    int[] shown = new int[1];
    double[] mostPx = new double[1];
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      if (isShown(viewport, pose.at(), radiusMm)) {
        shown[0]++;
        mostPx[0] = Math.max(mostPx[0], radiusMm * viewport.pxPerMm());
      }
    });
    if (shown[0] > most && mostPx[0] < LARGE_PX) {
      many(page, scene, viewport, look.theme());
    } else {
      few(page, scene, viewport, look.theme());
    }
    crosses(page, scene, viewport, look);
  }

  private void few(Graphics2D page, Scene scene, Viewport viewport, Theme theme) {
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      if (isShown(viewport, pose.at(), radiusMm)) {
        bodies.paint(
            page,
            viewport.xPx(pose.at()),
            viewport.yPx(pose.at()),
            radiusMm * viewport.pxPerMm(),
            pose.headingRad(),
            theme.robot(number),
            theme);
      }
    });
  }

  /** In device pixels, so that sprites are copied without scaling. */
  private void many(Graphics2D page, Scene scene, Viewport viewport, Theme theme) {
    Graphics2D device = (Graphics2D) page.create();
    AffineTransform at = page.getTransform();
    double scale = at.getScaleX();
    double left = at.getTranslateX();
    double top = at.getTranslateY();
    device.setTransform(new AffineTransform());
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      Point point = pose.at();
      if (isShown(viewport, point, radiusMm)) {
        double radiusPx = radiusMm * viewport.pxPerMm() * scale;
        int x = (int) Math.round(left + scale * viewport.xPx(point));
        int y = (int) Math.round(top + scale * viewport.yPx(point));
        if (radiusPx < SPECK_PX) {
          device.setColor(theme.robot(number));
          device.fillRect(x - 1, y - 1, 2, 2);
        } else {
          sprites.prepare(theme, radiusPx);
          device.drawImage(
              sprites.of(number, pose.headingRad()),
              x - sprites.halfPx(),
              y - sprites.halfPx(),
              null);
        }
      }
    });
    device.dispose();
  }

  private void crosses(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    for (RobotId robot : scene.down()) {
      scene
          .pose(robot)
          .ifPresent(pose ->
              bodies.paintCross(
                  page,
                  viewport.xPx(pose.at()),
                  viewport.yPx(pose.at()),
                  Math.max(4, scene.radiusMm(robot) * viewport.pxPerMm()),
                  look.theme()));
    }
  }

  private void selection(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    RobotId selected = look.selected();
    if (selected == null) {
      return;
    }
    if (look.shows(Part.RANGE) && look.rangeMm() > 0) {
      range(page, scene, viewport, look, selected);
    }
    if (look.shows(Part.ROBOTS)) {
      scene
          .pose(selected)
          .ifPresent(pose ->
              bodies.paintRing(
                  page,
                  viewport.xPx(pose.at()),
                  viewport.yPx(pose.at()),
                  scene.radiusMm(selected) * viewport.pxPerMm(),
                  look.theme()));
    }
  }

  private static void range(
      Graphics2D page, Scene scene, Viewport viewport, Look look, RobotId robot) {
    Optional<Pose> pose = scene.pose(robot);
    if (pose.isPresent()) {
      Point at = pose.get().at();
      double radiusPx = look.rangeMm() * viewport.pxPerMm();
      Ellipse2D disc = Figures.disc(viewport.xPx(at), viewport.yPx(at), radiusPx);
      Color colour = look.robot(scene, robot);
      page.setColor(Theme.faded(colour, 12));
      page.fill(disc);
      page.setColor(Theme.faded(colour, 150));
      float[] dashes = {6, 5};
      page.setStroke(
          new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0));
      page.draw(disc);
    }
  }

  /** Bursts of short lines, which fade. */
  private static void bumps(Graphics2D page, Scene scene, Viewport viewport, Theme theme) {
    for (Scene.Bump bump : scene.bumps()) {
      long ageNs = scene.nowNs() - bump.timeNs();
      if (ageNs <= BUMP_SHOWN_NS) {
        int alpha = (int) (255 - 200 * ageNs / BUMP_SHOWN_NS);
        double x = viewport.xPx(bump.at());
        double y = viewport.yPx(bump.at());
        page.setColor(Theme.faded(theme.alarm(), alpha));
        page.setStroke(new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        for (int i = 0; i < 8; i++) {
          double cos = StrictMath.cos(i * Math.PI / 4);
          double sin = StrictMath.sin(i * Math.PI / 4);
          page.draw(new Line2D.Double(x + 4 * cos, y + 4 * sin, x + 9 * cos, y + 9 * sin));
        }
      }
    }
  }
}
