package org.starl.apps;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.geometry.Obstacles;
import org.starl.spec.Monitor;

/**
 * The program of every robot of a run. Immutable.
 *
 * @param app makes a robot's app over its gvh; different robots may get different ones
 * @param knownObstacles the map that robots have at the start
 * @param monitors specifications, new ones at each call; a robot checks those of their lemmas that it
 *     can violate alone
 */
public record RobotProgram(
    Function<GlobalVarHolder, ? extends RobotApp> app,
    Obstacles knownObstacles,
    List<Supplier<? extends Monitor>> monitors) {

  public RobotProgram {
    monitors = List.copyOf(monitors);
  }

  /** A program without map and monitors. */
  public static RobotProgram of(Function<GlobalVarHolder, ? extends RobotApp> app) {
    return new RobotProgram(app, Obstacles.NONE, List.of());
  }

  /** The same program with another map. */
  public RobotProgram withMap(Obstacles known) {
    return new RobotProgram(app, known, monitors);
  }

  /** The same program with one more monitor. */
  public RobotProgram withMonitor(Supplier<? extends Monitor> monitor) {
    List<Supplier<? extends Monitor>> all = new ArrayList<>(monitors);
    all.add(monitor);
    return new RobotProgram(app, knownObstacles, all);
  }

  /** The number of this robot among all robots in the order of their names, from 0. */
  public static int number(GlobalVarHolder gvh) {
    return gvh.id.participants().asList().indexOf(gvh.id.name());
  }
}
