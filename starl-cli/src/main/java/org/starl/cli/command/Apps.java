package org.starl.cli.command;

import java.util.List;
import org.starl.apps.Demos;
import org.starl.apps.fleet.FleetDemo;
import org.starl.apps.hello.HelloDemo;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.apps.lightpaint.LightPaintDemo;
import org.starl.apps.maze.MazeDemo;
import org.starl.apps.race.RaceDemo;
import org.starl.apps.search.SearchDemo;
import org.starl.workload.PrimitiveWorkloads;

/** What the command line can run. */
public final class Apps {

  /** The apps of this project. */
  public static final Demos OWN =
      new Demos(
          List.of(
              new FleetDemo(),
              new HelloDemo(),
              new IntersectionDemo(),
              new LightPaintDemo(),
              new MazeDemo(),
              new RaceDemo(),
              new SearchDemo()));

  /** The apps and the primitives, each primitive with its workload. */
  public static final Demos ALL = OWN.plus(PrimitiveWorkloads.ALL);

  private Apps() {}

  /**
   * The apps on the class path, then those of this project.
   *
   * @throws org.starl.input.BadInput if one on the class path cannot be created
   */
  public static Demos installed() {
    return Demos.installed(ALL).plus(ALL.all());
  }
}
