package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.input.BadInput;
import org.starl.robot.optitrack.Axes;
import org.starl.robot.optitrack.PoseSource;

class TakeTest {

  /** As Motive 3 writes it: a column of time codes, a quoted name, markers beside the bodies, millimetres. */
  private static final String GOOD =
      """
      Format Version,1.25,Take Name,x,Capture Frame Rate,100.000000,Rotation Type,Quaternion,Length Units,Millimeters,Coordinate Space,Global

      ,Type,,Marker,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body Marker
      ,Name,,m,"a, b","a, b","a, b","a, b","a, b","a, b","a, b","a, b",m
      ,ID,,1,2,2,2,2,2,2,2,2,3
      ,,,Position,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker Error,Position
      Frame,Time (Seconds),TimeCode,X,X,Y,Z,W,X,Y,Z,,X
      100,1.000000,10:00:00,5,0,0.70710678,0,0.70710678,1000,10,-2000,0.25,
      101,1.010000,10:00:00,5,,,,,,,,,
      102,1.020000,10:00:00
      103,1.030000,10:00:00,5,0,0,0.70710678,0.70710678,1,2,3,0.5,
      104,1.040000,10:00:00,5,0,0,0,1,1500,10,0,0.5,
      """;

  @TempDir private Path folder;

  private Take read(String text) throws IOException {
    return Take.read(Files.writeString(folder.resolve("t.csv"), text), Axes.DEFAULT);
  }

  @Test
  void bodiesAreTrackedWhereTheyHaveAPoseOnTheFloor() throws IOException {
    Take take = read("\uFEFF" + GOOD.replace("\n", "\r\n"));
    assertThat(take.names()).containsExactly("a, b");
    assertThat(take.framesPerS()).isEqualTo(100);
    assertThat(take.frames())
        .extracting(PoseSource.Snapshot::atNs)
        .containsExactly(0L, 10_000_000L, 20_000_000L, 30_000_000L, 40_000_000L);
    List<PoseSource.Body> seen = take.frames().stream().map(each -> each.bodies().get(0)).toList();
    assertThat(seen)
        .extracting(PoseSource.Body::isTracked)
        .containsExactly(true, false, false, false, true);
    assertThat(take.tracked("a, b")).isEqualTo(2);
    assertThat(take.tracked("c")).isZero();
    for (PoseSource.Body body : seen.subList(0, 4)) { // not tracked: where it was before
      assertThat(body.pose().xMm()).isCloseTo(1000, within(1e-6));
      assertThat(body.pose().yMm()).isCloseTo(2000, within(1e-6));
      assertThat(body.pose().headingRad()).isCloseTo(StrictMath.PI / 2, within(1e-6));
    }
    assertThat(seen.get(0).meanErrorMm()).isCloseTo(0.25, within(1e-9));
    assertThat(seen.get(4).pose().xMm()).isCloseTo(1500, within(1e-6));
  }

  @Test
  void aTakeOfFormat121IsRead() throws IOException {
    String old =
        GOOD.replace("1.25", "1.21")
            .replaceAll(",(Type|Name|ID),", ",,")
            .replace("Time (Seconds)", "Time")
            .replace("Mean Marker Error", "Error Per Marker");
    assertThat(read(old)).isEqualTo(read(GOOD));
  }

  @Test
  void aTakeIsPlayedOnceByItsTimes() throws IOException {
    long[] nowNs = {5_000_000_000L};
    PoseSource source = read(GOOD).from(6_000_000_000L, () -> nowNs[0]);
    assertThat(source.snapshot().atNs()).as("before it").isEqualTo(5_000_000_000L);
    assertThat(source.snapshot().bodies().get(0).isTracked()).isTrue();
    nowNs[0] = 6_019_999_999L;
    assertThat(source.snapshot().atNs()).isEqualTo(6_010_000_000L);
    assertThat(source.snapshot().bodies().get(0).isTracked()).isFalse();
    nowNs[0] = 7_000_000_000L;
    assertThat(source.snapshot().atNs()).as("after it").isEqualTo(7_000_000_000L);
    assertThat(source.snapshot().bodies().get(0).pose().xMm()).isCloseTo(1500, within(1e-6));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Format Version|Version|:1: begins with another word|exported as CSV",
        "Quaternion|XYZ|:1: Rotation Type is 'XYZ'|expected Quaternion",
        "Millimeters|Inches|:1: Length Units is 'Inches'|expected Meters",
        "Frame,|Bild,|:13: has no row of titles|'Frame'",
        "Rigid Body,|Bone,|:7: has no rigid body|export these",
        "Z,W|Z,V|:7: rigid body 'a, b' has no column 'Rotation W'|",
        "0.25|x|:8: column 12 is 'x'|expected a number",
        "1000,|NaN,|:8: column 9 is 'NaN'|expected a number",
        "1.010000|0.990000|:9: Time (Seconds) is '0.990000'|expected a later time",
        "1.020000||:10: column 2 is ''|expected a number",
        "1500,10,0,|1500,10,,|:12: column 11 is ''|expected a number",
        "1500,10,0,0.5,|1500|:12: column 10 is ''|expected a number",
        "1500,10,0,0.5,|1500,0,10,0,0,0,5,|:12: column 14 is '0'|expected 13 columns, as the titles have"
      })
  void aWrongTakeIsRefusedWithItsLine(String of, String with, String says, String expected) {
    String text = GOOD.replace(of, with == null ? "" : with);
    assertThat(text).isNotEqualTo(GOOD);
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInput.class)
        .hasMessageContainingAll("t.csv" + says, expected == null ? "" : expected);
  }

  @Test
  void aLineWithoutEndIsRefused() {
    assertThatThrownBy(() -> read("x".repeat(1_000_002)))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("t.csv:1: is longer than 1000000 characters; expected a take");
  }

  @Test
  void aTakeWithoutFramesIsRefused() {
    String text = GOOD.substring(0, GOOD.indexOf("100,1.0"));
    assertThatThrownBy(() -> read(text)).hasMessageContaining("t.csv:8: ends without a frame");
  }

  @Test
  void bytesThatAreNoTextAreRefused() throws IOException {
    Path file = Files.write(folder.resolve("t.csv"), new byte[] {70, (byte) 0xFF, 10});
    assertThatThrownBy(() -> Take.read(file, Axes.DEFAULT))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("t.csv");
  }
}
