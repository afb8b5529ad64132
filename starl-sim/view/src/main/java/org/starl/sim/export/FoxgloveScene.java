package org.starl.sim.export;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;
import org.starl.sim.view.page.FloorShapes;
import org.starl.spec.Bodies;
import org.starl.time.Time;

/**
 * Makes Foxglove's messages as JSON (docs.foxglove.dev/docs/visualization/message-schemas). All
 * coordinates are in metres in the frame {@code world}; z points up from the floor.
 */
final class FoxgloveScene {

  private static final String FRAME = "world";
  private static final double MM_PER_M = 1000;
  private static final double BODY_HEIGHT_M = 0.09; // an iRobot Create's
  private static final double WALL_WIDTH_M = 0.02;
  private static final double TRAIL_WIDTH_M = 0.01;
  private static final double AREA_DEPTH_M = 0.005; // below the lines, so that these are seen
  private static final int LINE_STRIP = 0;
  private static final int LINE_LOOP = 1;
  private static final String[] KINDS = {
    "metadata", "arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"
  };

  private final ObjectMapper json;

  FoxgloveScene(ObjectMapper json) {
    this.json = json;
  }

  /** An empty {@code foxglove.SceneUpdate}. */
  ObjectNode update() {
    ObjectNode update = json.createObjectNode();
    update.putArray("deletions");
    update.putArray("entities");
    return update;
  }

  /** A {@code foxglove.SceneUpdate} that deletes the entity {@code id}. */
  ObjectNode deletion(long timeNs, String id) {
    ObjectNode update = update();
    ObjectNode deletion = update.withArray("deletions").addObject();
    time(deletion.putObject("timestamp"), timeNs);
    deletion.put("type", 0).put("id", id);
    return update;
  }

  void addObstacle(ObjectNode update, String id, Obstacle obstacle) {
    int kind = obstacle.closed() ? LINE_LOOP : LINE_STRIP;
    ObjectNode line = line(entity(update, 0, id), kind, WALL_WIDTH_M);
    obstacle.points().forEach(point -> addPoint(line, point.xMm(), point.yMm()));
    if (obstacle.hidden()) {
      colour(line.putObject("color"), 0.69, 0.25, 0.13);
    } else {
      colour(line.putObject("color"), 0.33, 0.33, 0.33);
    }
  }

  void addBody(ObjectNode update, long timeNs, String id, Bodies bodies, RobotId robot) {
    ObjectNode entity = entity(update, timeNs, id);
    Pose at = bodies.poseAt(robot, timeNs);
    double diameterM = 2 * bodies.radiusMm(robot) / MM_PER_M;
    double xM = at.xMm() / MM_PER_M;
    double yM = at.yMm() / MM_PER_M;
    ObjectNode disc = entity.withArray("cylinders").addObject();
    pose(disc.putObject("pose"), xM, yM, BODY_HEIGHT_M / 2, 0);
    xyz(disc.putObject("size"), diameterM, diameterM, BODY_HEIGHT_M);
    disc.put("bottom_scale", 1).put("top_scale", 1);
    colour(disc.putObject("color"), 0, 0.45, 0.7);
    ObjectNode heading = entity.withArray("arrows").addObject();
    pose(heading.putObject("pose"), xM, yM, BODY_HEIGHT_M, at.headingRad());
    heading
        .put("shaft_length", diameterM / 2)
        .put("shaft_diameter", diameterM / 16)
        .put("head_length", diameterM / 6)
        .put("head_diameter", diameterM / 8);
    colour(heading.putObject("color"), 0.9, 0.62, 0);
    ObjectNode name = entity.withArray("texts").addObject();
    pose(name.putObject("pose"), xM, yM, 2 * BODY_HEIGHT_M, 0);
    name.put("billboard", true).put("font_size", 12).put("scale_invariant", true);
    colour(name.putObject("color"), 0.13, 0.13, 0.13);
    name.put("text", robot.name());
  }

  /** A {@code foxglove.FrameTransforms}: a frame for each body. */
  ObjectNode transforms(long timeNs, Bodies bodies, List<RobotId> robots) {
    ObjectNode message = json.createObjectNode();
    ArrayNode all = message.putArray("transforms");
    for (RobotId robot : robots) {
      Pose at = bodies.poseAt(robot, timeNs);
      ObjectNode one = all.addObject();
      time(one.putObject("timestamp"), timeNs);
      one.put("parent_frame_id", FRAME).put("child_frame_id", robot.name());
      xyz(one.putObject("translation"), at.xMm() / MM_PER_M, at.yMm() / MM_PER_M, 0);
      turn(one.putObject("rotation"), at.headingRad());
    }
    return message;
  }

  void addTrail(ObjectNode update, long timeNs, String id, List<Point> trail) {
    ObjectNode line = line(entity(update, timeNs, id), LINE_STRIP, TRAIL_WIDTH_M);
    trail.forEach(point -> addPoint(line, point.xMm(), point.yMm()));
    colour(line.putObject("color"), 0, 0.45, 0.7);
  }

  /** What the app draws: outlines as lines, filled convex areas, texts. Dots become a line. */
  void addDrawing(ObjectNode update, long timeNs, List<FloorShapes.Item> items) {
    ObjectNode entity = entity(update, timeNs, "floor");
    for (FloorShapes.Item item : items) {
      double[] xy = item.xyMm();
      if (!item.text().isEmpty()) {
        ObjectNode text = entity.withArray("texts").addObject();
        pose(text.putObject("pose"), xy[0] / MM_PER_M, xy[1] / MM_PER_M, 0, 0);
        text.put("billboard", true).put("font_size", item.sizeMm() / MM_PER_M);
        text.put("scale_invariant", false).put("text", item.text());
        colour(text.putObject("color"), item.rgba());
      } else if (item.isFilled()) {
        ObjectNode area = entity.withArray("triangles").addObject();
        pose(area.putObject("pose"), 0, 0, -AREA_DEPTH_M, 0);
        for (int i = 2; i + 3 < xy.length; i += 2) {
          addPoint(area, xy[0], xy[1]);
          addPoint(area, xy[i], xy[i + 1]);
          addPoint(area, xy[i + 2], xy[i + 3]);
        }
        colour(area.putObject("color"), item.rgba());
        area.putArray("colors");
        area.putArray("indices");
      } else {
        int kind = item.isClosed() ? LINE_LOOP : LINE_STRIP;
        ObjectNode line = line(entity, kind, item.sizeMm() / MM_PER_M);
        for (int i = 0; i < xy.length; i += 2) {
          addPoint(line, xy[i], xy[i + 1]);
        }
        colour(line.putObject("color"), item.rgba());
      }
    }
  }

  private static ObjectNode line(ObjectNode entity, int kind, double widthM) {
    ObjectNode line = entity.withArray("lines").addObject();
    line.put("type", kind);
    pose(line.putObject("pose"), 0, 0, 0, 0);
    line.put("thickness", widthM).put("scale_invariant", false);
    line.putArray("points");
    line.putArray("colors");
    line.putArray("indices");
    return line;
  }

  private static void addPoint(ObjectNode shape, double xMm, double yMm) {
    xyz(shape.withArray("points").addObject(), xMm / MM_PER_M, yMm / MM_PER_M, 0);
  }

  /** A {@code foxglove.PoseInFrame}. */
  ObjectNode pose(long timeNs, Bodies bodies, RobotId robot) {
    Pose at = bodies.poseAt(robot, timeNs);
    ObjectNode message = json.createObjectNode();
    time(message.putObject("timestamp"), timeNs);
    message.put("frame_id", FRAME);
    pose(message.putObject("pose"), at.xMm() / MM_PER_M, at.yMm() / MM_PER_M, 0, at.headingRad());
    return message;
  }

  /** A {@code foxglove.Log}. */
  ObjectNode log(long timeNs, Level level, String name, String text) {
    ObjectNode message = json.createObjectNode();
    time(message.putObject("timestamp"), timeNs);
    int number =
        switch (level) {
          case DEBUG -> 1;
          case INFO -> 2;
          case WARN -> 3;
          case ERROR -> 4;
        };
    return message
        .put("level", number)
        .put("message", text)
        .put("name", name)
        .put("file", "")
        .put("line", 0);
  }

  private ObjectNode entity(ObjectNode update, long timeNs, String id) {
    ObjectNode entity = update.withArray("entities").addObject();
    time(entity.putObject("timestamp"), timeNs);
    entity.put("frame_id", FRAME).put("id", id);
    time(entity.putObject("lifetime"), 0); // until replaced
    entity.put("frame_locked", false);
    for (String kind : KINDS) {
      entity.putArray(kind);
    }
    return entity;
  }

  private static void time(ObjectNode node, long timeNs) {
    node.put("sec", timeNs / Time.NS_PER_S).put("nsec", timeNs % Time.NS_PER_S);
  }

  private static void xyz(ObjectNode node, double x, double y, double z) {
    node.put("x", x).put("y", y).put("z", z);
  }

  private static void pose(ObjectNode node, double xM, double yM, double zM, double headingRad) {
    xyz(node.putObject("position"), xM, yM, zM);
    turn(node.putObject("orientation"), headingRad);
  }

  private static void turn(ObjectNode turn, double headingRad) {
    xyz(turn, 0, 0, StrictMath.sin(headingRad / 2));
    turn.put("w", StrictMath.cos(headingRad / 2));
  }

  private static void colour(ObjectNode node, int rgba) {
    double full = 255;
    colour(node, ((rgba >> 16) & 255) / full, ((rgba >> 8) & 255) / full, (rgba & 255) / full);
    node.put("a", (rgba >>> 24) / full);
  }

  private static void colour(ObjectNode node, double red, double green, double blue) {
    node.put("r", red).put("g", green).put("b", blue).put("a", 1);
  }
}
