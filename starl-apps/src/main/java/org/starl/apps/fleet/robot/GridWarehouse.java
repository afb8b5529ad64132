package org.starl.apps.fleet.robot;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Point;

/**
 * The built-in map: one-way streets in a square grid, as in Manhattan. In each block is a robot's home, a
 * charger or a station. A station lies beside the street, so a robot that stops there holds up no robot
 * that passes.
 */
final class GridWarehouse {

  /** From one street to the next. */
  private static final double BLOCK_MM = 1_300;

  private static final int ROBOTS_A_CHARGER = 6;

  private final List<Vertex> vertices = new ArrayList<>();
  private final List<Lane> lanes = new ArrayList<>();
  private final int blocks;

  private GridWarehouse(int blocks) {
    this.blocks = blocks;
  }

  /** With as many homes as robots, a charger for six of them, and stations in all other blocks. */
  static NavGraph of(int robots) {
    int chargers = (robots + ROBOTS_A_CHARGER - 1) / ROBOTS_A_CHARGER;
    int stations = Math.max(4, robots / 2);
    int blocks = (int) StrictMath.ceil(StrictMath.sqrt(robots + chargers + stations));
    blocks += blocks % 2 == 0 ? 1 : 0; // then the streets at the edge go round
    GridWarehouse grid = new GridWarehouse(blocks);
    grid.addStreets();
    grid.addBlocks(robots, chargers);
    return new NavGraph(grid.vertices, grid.lanes);
  }

  private void addStreets() {
    for (int row = 0; row <= blocks; row++) {
      for (int column = 0; column <= blocks; column++) {
        vertices.add(new Vertex("x" + column + "y" + row, at(column, row), false, false, false));
      }
    }
    for (int line = 0; line <= blocks; line++) {
      for (int i = 0; i < blocks; i++) {
        boolean isForth = line % 2 == 0;
        addStreet(crossing(i, line), crossing(i + 1, line), isForth);
        addStreet(crossing(line, i), crossing(line, i + 1), !isForth);
      }
    }
  }

  private void addStreet(int one, int other, boolean isForth) {
    lanes.add(isForth ? new Lane(one, other, "") : new Lane(other, one, ""));
  }

  private int crossing(int column, int row) {
    return row * (blocks + 1) + column;
  }

  private static Point at(double column, double row) {
    return new Point(BLOCK_MM * column, BLOCK_MM * row);
  }

  /** Stations and chargers are spread evenly among the homes. */
  private void addBlocks(int robots, int chargers) {
    int all = blocks * blocks;
    int homes = 0;
    int charging = 0;
    for (int i = 0; i < all; i++) {
      int column = i % blocks;
      int row = i / blocks;
      if ((i + 1) * robots / all > homes) {
        homes++;
        addEnd("home" + homes, column, row, false);
      } else if ((i * chargers + all / 2) / all > charging) {
        charging++;
        addEnd("charger" + charging, column, row, true);
      } else {
        addStation("station" + (i + 1 - homes - charging), column, row);
      }
    }
  }

  private void addEnd(String name, int column, int row, boolean isCharger) {
    int place = vertices.size();
    vertices.add(new Vertex(name, at(column + 0.5, row + 0.5), isCharger, false, !isCharger));
    lanes.add(new Lane(crossing(column, row), place, ""));
    lanes.add(new Lane(place, crossing(column, row), ""));
  }

  private void addStation(String name, int column, int row) {
    int place = vertices.size();
    vertices.add(new Vertex(name, at(column + 0.5, row + 0.5), false, true, false));
    boolean isUp = column % 2 != 0;
    lanes.add(new Lane(crossing(column, isUp ? row : row + 1), place, ""));
    lanes.add(new Lane(place, crossing(column, isUp ? row + 1 : row), ""));
  }
}
