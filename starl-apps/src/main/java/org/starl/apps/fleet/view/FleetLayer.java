package org.starl.apps.fleet.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.FleetFact;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.apps.fleet.logic.Roads;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * Draws lanes with an arrow in each direction, stations as squares, chargers as rings, loads that wait at
 * stations or are aboard as filled squares, and each robot's way dotted.
 */
public final class FleetLayer implements Layer {

  private static final String LANES = "lanes";
  private static final String LOADS = "loads";
  private static final String WAYS = "ways";
  private static final double STATION_MM = 420;
  private static final double LOAD_MM = 150;
  private static final double ARROW_MM = 90;

  private final Roads roads;
  private final List<Delivery> deliveries;
  private final SortedSet<Long> fetched = new TreeSet<>();

  public FleetLayer(Roads roads, List<Delivery> deliveries) {
    this.roads = roads;
    this.deliveries = List.copyOf(deliveries);
  }

  @Override
  public FleetLayer copy() {
    FleetLayer copy = new FleetLayer(roads, deliveries);
    copy.fetched.addAll(fetched);
    return copy;
  }

  @Override
  public void observe(TraceEvent event) {
    if (event instanceof Variable variable) {
      Long aboard = variable.of(FleetFact.ABOARD);
      if (aboard != null && aboard > 0) {
        fetched.add(aboard);
      }
    }
  }

  @Override
  public List<Point> corners() {
    return roads.graph().vertices().stream().map(Vertex::at).toList();
  }

  @Override
  public List<String> parts() {
    return List.of(LANES, LOADS, WAYS);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    if (look.shows(LANES)) {
      floor.setColor(look.theme().border());
      floor.setStroke(look.line(12));
      roads.graph().lanes().forEach(lane -> paintLane(floor, lane));
      roads.graph().vertices().forEach(vertex -> paintPlace(floor, vertex, look));
    }
    for (RobotId robot : look.shows(WAYS) ? scene.robots() : List.<RobotId>of()) {
      List<Integer> way = scene.variable(robot, FleetFact.WAY);
      Point at = scene.pose(robot).map(Pose::at).orElse(null);
      if (way != null && !way.isEmpty() && at != null) {
        Path2D line = new Path2D.Double();
        line.moveTo(at.xMm(), at.yMm());
        way.forEach(vertex -> line.lineTo(roads.at(vertex).xMm(), roads.at(vertex).yMm()));
        floor.setColor(look.robot(scene, robot));
        floor.setStroke(look.dots(4 * look.pixelMm(), 8 * look.pixelMm()));
        floor.draw(line);
      }
    }
  }

  private void paintLane(Graphics2D floor, Lane lane) {
    Point from = roads.at(lane.from());
    Point to = roads.at(lane.to());
    floor.draw(Figures.line(from, to));
    Point along = to.minus(from).times(1 / to.distanceMm(from));
    Point tip = from.plus(to.minus(from).times(0.62));
    Point left = new Point(-along.yMm(), along.xMm());
    Path2D arrow = new Path2D.Double();
    for (int side = -1; side <= 1; side += 2) {
      Point end = tip.minus(along.times(ARROW_MM)).plus(left.times(side * ARROW_MM / 2));
      arrow.moveTo(tip.xMm(), tip.yMm());
      arrow.lineTo(end.xMm(), end.yMm());
    }
    floor.draw(arrow);
  }

  private static void paintPlace(Graphics2D floor, Vertex vertex, Look look) {
    if (vertex.isStation()) {
      floor.setColor(look.theme().floor());
      floor.fill(square(vertex.at(), STATION_MM));
      floor.setColor(look.theme().border());
      floor.draw(square(vertex.at(), STATION_MM));
    } else if (vertex.isCharger()) {
      floor.setColor(look.theme().gold());
      floor.setStroke(new BasicStroke(30));
      floor.draw(Figures.disc(vertex.at(), STATION_MM / 2));
      floor.setColor(look.theme().border());
      floor.setStroke(look.line(12));
    }
  }

  private static Rectangle2D square(Point at, double sideMm) {
    return new Rectangle2D.Double(at.xMm() - sideMm / 2, at.yMm() - sideMm / 2, sideMm, sideMm);
  }

  /** Loads that wait lie beside each other at their station; those aboard, on their robot. */
  @Override
  public void paintOver(Graphics2D floor, Scene scene, Look look) {
    if (!look.shows(LOADS)) {
      return;
    }
    Color colour = look.theme().alarm();
    floor.setColor(colour);
    List<Integer> waiting = new ArrayList<>();
    for (int i = 0; i < deliveries.size(); i++) {
      int pick = deliveries.get(i).pick();
      if (deliveries.get(i).atNs() <= scene.nowNs() && !fetched.contains((long) i + 1)) {
        long before = waiting.stream().filter(each -> each == pick).count();
        Point at = roads.at(pick).plus(new Point(1.2 * LOAD_MM * before, STATION_MM / 2));
        floor.fill(square(at, LOAD_MM));
        waiting.add(pick);
      }
    }
    for (RobotId robot : scene.robots()) {
      Long aboard = scene.variable(robot, FleetFact.ABOARD);
      if (aboard != null && aboard > 0) {
        scene.pose(robot).ifPresent(pose -> floor.fill(square(pose.at(), LOAD_MM)));
      }
    }
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    Integer charge = scene.variable(robot, FleetFact.CHARGE);
    Long aboard = scene.variable(robot, FleetFact.ABOARD);
    return scene.text(robot, Instance.APP, FleetFact.WORK.name())
        + (aboard == null || aboard == 0 ? "" : ", delivery " + aboard + " aboard")
        + (charge == null ? "" : "\ncharge " + charge + " %");
  }

  /** Highest where most robots drive. */
  @Override
  public double interest(Scene scene) {
    return scene.robots().stream()
        .map(robot -> scene.variable(robot, FleetFact.WAY))
        .filter(way -> way != null && !way.isEmpty())
        .count();
  }
}
