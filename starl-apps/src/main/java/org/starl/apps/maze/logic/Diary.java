package org.starl.apps.maze.logic;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.gvh.GvhCell;
import org.starl.primitives.paths.Path;
import org.starl.trace.Instance;

/** Writes what one robot in a maze does into the trace. Strand only. */
final class Diary {

  private final GlobalVarHolder gvh;
  private final GvhCell<String> toward;
  private final GvhCell<MazeFact.Way> way;

  Diary(GlobalVarHolder gvh) {
    this.gvh = gvh;
    toward = gvh.variable(MazeFact.TOWARD, "");
    way = gvh.variable(MazeFact.WAY, MazeFact.Way.NONE);
  }

  void toward(String goal) {
    toward.set(goal);
  }

  void way(Path path) {
    way.set(MazeFact.Way.of(path));
  }

  void noWay() {
    way.set(MazeFact.Way.NONE);
  }

  void answer(Goal goal, Answer answer) {
    write(new MazeFact.Answered(goal.name(), answer, gvh.gps.errorMm()));
  }

  /** Writes the marks that exclude a body that is wider by the margin. */
  void marks(List<Mark> marks) {
    Mark.places(marks, 1).forEach(place -> write(new MazeFact.Marked(place)));
  }

  private void write(MazeFact fact) {
    gvh.trace.action(Instance.APP, MazeFact.SHAPE, fact);
  }
}
