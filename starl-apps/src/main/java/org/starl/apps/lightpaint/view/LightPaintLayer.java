package org.starl.apps.lightpaint.view;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.lightpaint.logic.Light;
import org.starl.apps.lightpaint.logic.LightPaintApp;
import org.starl.apps.lightpaint.logic.Location;
import org.starl.apps.lightpaint.logic.PaintFact;
import org.starl.apps.lightpaint.logic.Painting;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.spec.LightTrail;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.primitives.paths.Tube;
import org.starl.primitives.paths.TubeFact;
import org.starl.primitives.paths.TubeList;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/** Draws what is still to be painted dotted, what is painted in its colour, and the tubes. */
public final class LightPaintLayer implements Layer {

  private static final Instance TUBES = Instance.of(TubeFact.PRIMITIVE, LightPaintApp.XID);
  private static final double MIN_WIDTH_MM = 24;
  private static final int TUBE_ALPHA = 40;
  private static final String DRAWING = "drawing";
  private static final String PAINTED = "painted";
  private static final String REACH_TUBES = "tubes";

  private final Painting painting;
  private final LightTrail trail;

  public LightPaintLayer(Painting painting) {
    this(painting, new LightTrail());
  }

  private LightPaintLayer(Painting painting, LightTrail trail) {
    this.painting = painting;
    this.trail = trail;
  }

  @Override
  public LightPaintLayer copy() {
    return new LightPaintLayer(painting, trail.copy());
  }

  @Override
  public void observe(TraceEvent event) {
    trail.observe(event);
  }

  @Override
  public boolean showsTrails() {
    return false;
  }

  @Override
  public SortedMap<String, Rectangle> areas() {
    return new TreeMap<>(Map.of("floor", painting.floor()));
  }

  @Override
  public List<Point> corners() {
    return painting.floor().corners();
  }

  @Override
  public List<String> parts() {
    return List.of(DRAWING, PAINTED, REACH_TUBES);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    trail.advance(scene.nowNs());
    for (RobotId robot : look.shows(REACH_TUBES) ? scene.robots() : List.<RobotId>of()) {
      TubeList held = scene.variable(robot, TUBES, TubeFact.HELD);
      for (Tube tube : held == null ? List.<Tube>of() : held.tubes()) {
        floor.setColor(Theme.faded(look.robot(scene, robot), TUBE_ALPHA));
        floor.setStroke(look.line(2 * tube.radiusMm()));
        floor.draw(Figures.line(tube.points()));
      }
    }
    for (Stroke stroke : look.shows(DRAWING) ? painting.strokes() : List.<Stroke>of()) {
      floor.setColor(look.theme().muted());
      floor.setStroke(look.dashes(8, 24));
      floor.draw(Figures.line(stroke.path().points()));
    }
    for (Pass pass : look.shows(PAINTED) ? trail.passes() : List.<Pass>of()) {
      floor.setColor(look.theme().visible(new Color(pass.ink().rgb())));
      floor.setStroke(look.line(Math.max(MIN_WIDTH_MM, pass.ink().widthMm())));
      floor.draw(Figures.line(pass.points()));
    }
  }

  private static Light light(RobotId robot, Scene scene) {
    Light light = scene.variable(robot, PaintFact.LIGHT);
    return light == null ? Light.OFF : light;
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    Location known = scene.variable(robot, PaintFact.LOCATION);
    Location location = known == null ? Location.RESUME : known;
    String stroke = scene.text(robot, Instance.APP, PaintFact.STROKE.name());
    Light light = light(robot, scene);
    String doing =
        switch (location) {
          case PAINT ->
              light.ink() == null
                  ? "waits for its tube along stroke " + stroke
                  : "paints stroke " + stroke + " in " + light.ink().colour();
          case GO -> "goes to stroke " + stroke;
          case ASK -> "asks for stroke " + stroke;
          case RETREAT -> "gives way, at its home";
          case PARK, DONE -> "is done";
          case RESUME, PICK -> "looks for a stroke";
        };
    return doing + String.format(Locale.ROOT, "%nhas painted %.2f m", trail.paintedMm(robot) / 1e3);
  }

  /** Highest when many lights are on and part of the drawing is painted. */
  @Override
  public double interest(Scene scene) {
    long lit = scene.robots().stream().filter(robot -> light(robot, scene).isOn()).count();
    double done = trail.passes().size() / (double) Math.max(1, painting.strokes().size());
    return lit + 2 * Math.min(done, 0.6);
  }
}
