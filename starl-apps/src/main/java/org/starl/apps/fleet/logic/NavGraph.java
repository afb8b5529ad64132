package org.starl.apps.fleet.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;

/**
 * A navigation graph: places on the floor, and lanes along which robots drive between them. Both are
 * numbered by their place in the list.
 *
 * @param vertices places; each name is unique
 * @param lanes one for each direction that may be driven
 * @param walls of the building, in the world and in pictures; robots drive by the lanes alone
 */
public record NavGraph(List<Vertex> vertices, List<Lane> lanes, Obstacles walls) {

  /** Without walls. */
  public NavGraph(List<Vertex> vertices, List<Lane> lanes) {
    this(vertices, lanes, Obstacles.NONE);
  }

  /**
   * A place where one robot may stand.
   *
   * @param at on the floor, in mm
   * @param isCharger whether a robot can charge there
   * @param isStation whether loads are picked up and put down there
   * @param isParking whether a robot without work may wait there
   * @param group which a robot uses that stands there, or is on a lane from or to it; empty for none
   */
  public record Vertex(
      String name,
      Point at,
      boolean isCharger,
      boolean isStation,
      boolean isParking,
      String group) {

    public Vertex(String name, Point at, boolean isCharger, boolean isStation, boolean isParking) {
      this(name, at, isCharger, isStation, isParking, "");
    }
  }

  /**
   * A straight way in one direction.
   *
   * @param from number of the vertex where it begins
   * @param to number of the vertex where it ends
   * @param group each group is used by one robot at a time; empty for none
   */
  public record Lane(int from, int to, String group) {

    /** The same way, driven back. */
    Lane reversed() {
      return new Lane(to, from, group);
    }
  }

  public NavGraph {
    vertices = List.copyOf(vertices);
    lanes = List.copyOf(lanes);
    for (Lane lane : lanes) {
      if (!isVertex(lane.from(), vertices)
          || !isVertex(lane.to(), vertices)
          || lane.from() == lane.to()) {
        throw new IllegalArgumentException("not a lane between two vertices: " + lane);
      }
    }
  }

  private static boolean isVertex(int number, List<Vertex> vertices) {
    return number >= 0 && number < vertices.size();
  }

  /** The numbers of the vertices where loads are picked up and put down, in order. */
  public List<Integer> stations() {
    List<Integer> stations = new ArrayList<>();
    for (int v = 0; v < vertices.size(); v++) {
      if (vertices.get(v).isStation()) {
        stations.add(v);
      }
    }
    return stations;
  }

  /** The groups of a lane: its own, and those of its ends. */
  public SortedSet<String> groups(Lane lane) {
    SortedSet<String> groups = new TreeSet<>();
    groups.add(lane.group());
    groups.add(vertices.get(lane.from()).group());
    groups.add(vertices.get(lane.to()).group());
    groups.remove("");
    return groups;
  }

  /** Length of a lane in mm. */
  public double lengthMm(Lane lane) {
    return vertices.get(lane.from()).at().distanceMm(vertices.get(lane.to()).at());
  }
}
