package org.starl.apps.maze.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.primitives.paths.Path;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.Shape;

/** What a robot in a maze tells its trace. */
class MazeFactTest {

  private static final MazeFact.Way WAY =
      MazeFact.Way.of(new Path(List.of(new Point(499.6, -0.4), new Point(900, 1_500))));

  @Test
  void aWayIsToldInWholeMm() {
    assertThat(WAY.points()).containsExactly(new Point(500, 0), new Point(900, 1_500));
    assertThat(WAY).hasToString("500,0>900,1500");
    assertThat(MazeFact.Way.NONE).hasToString("");
  }

  @Test
  void valuesAndFactsAreReadFromJson() throws JsonFormatException {
    assertRead(MazeFact.Way.SHAPE, WAY);
    assertRead(MazeFact.Way.SHAPE, MazeFact.Way.NONE);
    Polygon place = Polygon.of(new Point(0, 0), new Point(10, 0), new Point(0, 10));
    assertRead(MazeFact.SHAPE, new MazeFact.Marked(place));
    assertRead(MazeFact.SHAPE, new MazeFact.Answered("G0", Answer.NO_WAY, 12.5));
  }

  private static <T> void assertRead(Shape<T> shape, T value) throws JsonFormatException {
    String json = shape.json(value);
    assertThat(shape.readJson(new JsonReader("trace", 1, json))).as(json).isEqualTo(value);
  }
}
