package org.starl.apps.maze.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.StringJoiner;
import java.util.TreeMap;
import org.starl.apps.maze.logic.Answer;
import org.starl.apps.maze.logic.Goal;
import org.starl.apps.maze.logic.MazeFact;
import org.starl.apps.maze.logic.MazeTask;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.id.RobotId;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * Draws the goals, crossed out if there is no way, the marks that contacts have proven, and each
 * robot's intended way dotted.
 */
public final class MazeLayer implements Layer {

  private static final String GOALS = "goals";
  private static final String MARKS = "marks";
  private static final String WAYS = "ways";
  private static final int MARK_ALPHA = 60;
  private static final double GOAL_PX = 9;

  private final SortedMap<RobotId, MazeTask> tasks;
  private final Map<RobotId, List<Polygon>> marks = new TreeMap<>();
  private final Map<GoalOf, Answer> answers = new HashMap<>();

  private record GoalOf(RobotId robot, String goal) {}

  public MazeLayer(SortedMap<RobotId, MazeTask> tasks) {
    this.tasks = new TreeMap<>(tasks);
  }

  @Override
  public MazeLayer copy() {
    MazeLayer copy = new MazeLayer(tasks);
    marks.forEach((robot, polygons) -> copy.marks.put(robot, new ArrayList<>(polygons)));
    copy.answers.putAll(answers);
    return copy;
  }

  @Override
  public void observe(TraceEvent event) {
    if (event instanceof Action action && action.fact() instanceof MazeFact fact) {
      switch (fact) {
        case MazeFact.Marked marked ->
            marks.computeIfAbsent(action.robot(), robot -> new ArrayList<>()).add(marked.place());
        case MazeFact.Answered answered ->
            answers.put(new GoalOf(action.robot(), answered.goal()), answered.answer());
      }
    }
  }

  @Override
  public List<Point> corners() {
    return tasks.isEmpty() ? List.of() : floor().vertices();
  }

  private Polygon floor() {
    return tasks.firstEntry().getValue().floor().outline();
  }

  @Override
  public List<String> parts() {
    return List.of(GOALS, MARKS, WAYS);
  }

  @Override
  public void paintFloor(Graphics2D floor, Scene scene, Look look) {
    if (!tasks.isEmpty()) {
      floor.setColor(look.theme().floor());
      floor.fill(Figures.line(floor().vertices()));
    }
    for (RobotId robot : scene.robots()) {
      // If a robot is selected, only its own marks.
      boolean isShown = look.selected() == null || look.selected().equals(robot);
      if (isShown && look.shows(MARKS)) {
        Color colour = look.robot(scene, robot);
        marks.getOrDefault(robot, List.of()).forEach(mark -> paintMark(floor, mark, colour, look));
      }
    }
    for (RobotId robot : look.shows(WAYS) ? scene.robots() : List.<RobotId>of()) {
      MazeFact.Way way = scene.variable(robot, MazeFact.WAY);
      if (way != null && !way.points().isEmpty()) {
        floor.setColor(look.robot(scene, robot));
        floor.setStroke(look.dots(4 * look.pixelMm(), 8 * look.pixelMm()));
        floor.draw(Figures.line(way.points()));
      }
    }
  }

  @Override
  public void paintOver(Graphics2D floor, Scene scene, Look look) {
    for (RobotId robot : look.shows(GOALS) ? scene.robots() : List.<RobotId>of()) {
      MazeTask task = tasks.get(robot);
      if (task != null) {
        Color colour = look.robot(scene, robot);
        task.goals().forEach(goal -> paintGoal(floor, robot, goal, colour, look));
      }
    }
  }

  private static void paintMark(Graphics2D floor, Polygon mark, Color colour, Look look) {
    Path2D outline = Figures.polygon(mark.vertices());
    floor.setColor(Theme.faded(colour, MARK_ALPHA));
    floor.fill(outline);
    floor.setStroke(look.line(4));
    floor.draw(outline);
  }

  /** A flag on a pole; crossed out once the robot has answered that there is no way, or gave up. */
  private void paintGoal(Graphics2D floor, RobotId robot, Goal goal, Color colour, Look look) {
    double px = look.pixelMm();
    double x = goal.at().xMm();
    double y = goal.at().yMm();
    double size = GOAL_PX * px;
    floor.setColor(look.theme().edge(colour));
    floor.setStroke(new BasicStroke((float) (2.5 * px)));
    floor.draw(new Line2D.Double(x, y, x, y + 2.4 * size));
    floor.fill(
        Figures.polygon(x, y + 2.4 * size, x + 1.6 * size, y + 1.8 * size, x, y + 1.2 * size));
    Answer answer = answers.get(new GoalOf(robot, goal.name()));
    if (answer == Answer.NO_WAY || answer == Answer.GAVE_UP) {
      floor.setColor(look.theme().alarm());
      floor.setStroke(new BasicStroke((float) (3.5 * px)));
      floor.draw(new Line2D.Double(x - size, y, x + 2 * size, y + 2.6 * size));
      floor.draw(new Line2D.Double(x - size, y + 2.6 * size, x + 2 * size, y));
    }
    Font font = new Font(Font.SANS_SERIF, Font.BOLD, 1).deriveFont((float) (12 * px));
    floor.setColor(look.theme().edge(colour));
    Figures.text(floor, goal.name(), font, x + 1.7 * size, y + 1.7 * size);
  }

  @Override
  public String describe(RobotId robot, Scene scene) {
    MazeTask task = tasks.get(robot);
    if (task == null) {
      return "";
    }
    StringJoiner answered = new StringJoiner(", ", "\n", "");
    answered.setEmptyValue("");
    for (Goal goal : task.goals()) {
      Answer answer = answers.get(new GoalOf(robot, goal.name()));
      if (answer != null) {
        answered.add(
            goal.name()
                + switch (answer) {
                  case REACHED -> " reached";
                  case NO_WAY -> ": no way";
                  case GAVE_UP -> ": gave up";
                });
      }
    }
    String toward = scene.text(robot, Instance.APP, MazeFact.TOWARD.name());
    int learned = marks.getOrDefault(robot, List.of()).size();
    return scene.text(robot, Instance.APP, MazeFact.LOCATION.name())
        + (toward.isEmpty() ? "" : ", to " + toward)
        + (learned == 0 ? "" : ", " + learned + " marks")
        + answered;
  }

  /** Highest at the end of a run, when all goals are answered. */
  @Override
  public double interest(Scene scene) {
    int driven = scene.robots().stream().mapToInt(scene::driven).sum();
    return answers.size() + 1e-4 * driven;
  }
}
