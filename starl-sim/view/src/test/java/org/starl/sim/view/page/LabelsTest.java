package org.starl.sim.view.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Part;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Viewport;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

/** Where the painter writes the names and locations of robots. */
class LabelsTest {

  private static final int SIDE_PX = 600;
  private static final Var<String> LOCATION = Var.of("location", Shapes.TEXT);

  private static List<DrawnItem> texts(List<@IntRange(max = 2000) Integer> places) {
    Scene scene = new Scene(Obstacles.NONE);
    for (int i = 0; i + 1 < places.size(); i += 2) {
      RobotId robot = new RobotId("bot" + i / 2);
      Point at = new Point(places.get(i), places.get(i + 1));
      scene.observe(new TraceEvent.Joined(0, robot, Pose.of(at, 0), 60));
      scene.observe(new TraceEvent.Variable(0, robot, Instance.APP, LOCATION, "REGISTER_WAIT"));
    }
    List<DrawnItem> items = new ArrayList<>();
    Look look = Look.FILE.with(Part.LOCATIONS, true);
    Viewport viewport = new Viewport(SIDE_PX, SIDE_PX, new Point(1000, 1000), 0.25);
    Painter.ofShapes()
        .paint(
            Painter.Section.LABELS,
            new ShapeRecorder(items),
            scene,
            Layer.NONE,
            viewport,
            look,
            List.of());
    // Halos are transparent.
    return items.stream().filter(item -> item.rgba() >>> 24 == 255).toList();
  }

  private static Rectangle2D area(DrawnItem text) {
    int[] n = text.numbers();
    return new Rectangle2D.Double(n[1] / 10.0, n[2] / 10.0 - 9, n[0] / 10.0, 11);
  }

  @Property(tries = 200)
  void labelsDoNotOverlapAndEachRobotIsNamedOrCounted(
      @ForAll @Size(min = 2, max = 60) List<@IntRange(max = 2000) Integer> places) {
    List<DrawnItem> texts = texts(places);
    List<DrawnItem> labels = texts.stream().filter(text -> !text.text().contains(" ")).toList();
    for (int i = 0; i < labels.size(); i++) {
      for (int j = 0; j < i; j++) {
        assertThat(area(labels.get(i)).intersects(area(labels.get(j))))
            .as("%s over %s", labels.get(i), labels.get(j))
            .isFalse();
      }
    }
    long named = labels.stream().filter(text -> text.text().startsWith("bot")).count();
    int counted =
        texts.stream()
            .filter(text -> text.text().contains(" without room"))
            .mapToInt(text -> Integer.parseInt(text.text().substring(0, text.text().indexOf(' '))))
            .sum();
    assertThat(named + counted).isEqualTo(places.size() / 2);
  }
}
