package org.starl.sim.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

class TakeTableTest {

  private static final RobotId ONE = new RobotId("bot0");
  private static final RobotId LATE = new RobotId("bot1");

  @Test
  void eachFrameHasThePosesOfItsTime() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (TakeTable table = new TakeTable(out)) {
      table.started(new TraceHeader("0", "a", 7, 8, Map.of(), List.of(ONE, LATE)));
      table.observed(new TraceEvent.Joined(0, ONE, new Pose(1000, 2000, StrictMath.PI / 2), 150));
      table.observed(
          new TraceEvent.Moved(10_000_000, ONE, new Pose(1000, 2000, StrictMath.PI / 2), 100, 0));
      table.observed(new TraceEvent.Joined(20_000_000, LATE, new Pose(0, 0, 0), 150));
      table.observed(new TraceEvent.Left(35_000_000, ONE));
      table.observed(new TraceEvent.Left(41_000_000, LATE));
    }
    String[] lines = out.toString(StandardCharsets.UTF_8).split("\n", -1);
    assertThat(lines[0]).startsWith("Format Version,1.23,Take Name,a-7,").contains("Units,Meters");
    assertThat(lines[3]).startsWith(",,bot0,bot0").endsWith(",bot1");
    assertThat(lines[6]).isEqualTo("Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z,W,X,Y,Z");
    String turned = ",0.000000,0.707107,0.000000,0.707107,1.000000,0.000000,";
    String late = ",0.000000,0.000000,0.000000,1.000000,0.000000,0.000000,0.000000";
    String none = ",,,,,,,";
    assertThat(List.of(lines).subList(7, lines.length))
        .containsExactly(
            "0,0.000000" + turned + "-2.000000" + none,
            "1,0.010000" + turned + "-2.000000" + none,
            "2,0.020000" + turned + "-2.001000" + late,
            "3,0.030000" + turned + "-2.002000" + late,
            "4,0.040000" + none + late,
            "");
  }
}
