package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.request.RunRequestTest;

/** {@code starl record}: other programs read its files. */
class RecordTest {

  @TempDir private Path folder;

  @Test
  void aMovingPictureHasAFrameForEachStepOfTheRun() throws IOException {
    Path gif = folder.resolve("a.gif");
    Cli cli =
        Cli.run(
            "record",
            "hello",
            "--seed",
            "1",
            "--gif",
            "--every",
            "1s",
            "--width",
            "300",
            "--out",
            gif.toString());
    assertThat(cli.status()).isZero();
    assertThat(cli.text()).contains(gif.toString());
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    try (ImageInputStream in = ImageIO.createImageInputStream(gif.toFile())) {
      reader.setInput(in);
      assertThat(reader.getNumImages(true)).isBetween(4, 12);
      assertThat(reader.read(0).getWidth()).isEqualTo(300);
    } finally {
      reader.dispose();
    }
  }

  @Test
  void aPageOfAMinuteOfFourCarsHasTheWholeRunInLessThanTwoMegabytes() throws IOException {
    Path page = folder.resolve("crossing.html");
    Cli cli =
        Cli.run(
            "record",
            "intersection",
            "--seed",
            "7",
            "--set",
            "scenario=figure7",
            "--fault",
            "jump(bot1,600mm,at=2s)",
            "--for",
            "60s",
            "--html",
            page.toString());
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(page)
        .content()
        .contains("<title>intersection, seed 7</title>")
        .endsWith("</html>\n");
    assertThat(page).content().doesNotContain("http:", "https:", "{{");
    assertThat(Files.size(page)).isBetween(30_000L, 2_000_000L);
  }

  @Test
  void whatIsMadeOfATraceTellsThatItsRunDidNotFinish() throws IOException {
    Path trace = folder.resolve("unfinished.trace");
    Path png = folder.resolve("unfinished.png");
    Cli run = Cli.line(Apps.ALL, "run hello --seed 1 --for 1s --png " + png + " --trace " + trace);
    Path page = folder.resolve("unfinished.html");
    Cli cli = Cli.line(Apps.ALL, "record " + trace + " --html " + page);
    String told = "NOT FINISHED: [bot0, bot1, bot2, bot3]";
    assertThat(run.out()).contains(told);
    assertThat(cli.err()).contains(told);
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
  }

  @Test
  void anMcapFileHasALayoutBesideIt() throws IOException {
    Path file = folder.resolve("run.mcap");
    Path layout = folder.resolve("run.foxglove-layout.json");
    Cli cli = Cli.line(Apps.ALL, "record hello --seed 1 --mcap --out " + file);
    assertThat(cli.status()).isZero();
    assertThat(cli.out()).contains("layout for Foxglove: " + layout);
    assertThat(new ObjectMapper().readTree(layout.toFile()).path("configById").isEmpty()).isFalse();
  }

  @Test
  void aBagOfRosIsAFolderWithItsMetadata() throws IOException {
    Path bag = folder.resolve("bag");
    Cli cli = Cli.run("record", "hello", "--seed", "1", "--rosbag", "--out", bag.toString());
    assertThat(cli.status()).isZero();
    assertThat(Files.readString(bag.resolve("metadata.yaml")))
        .contains(
            "name: /pose/bot0, type: geometry_msgs/msg/PoseStamped, serialization_format: cdr");
    assertThat(new String(Files.readAllBytes(bag.resolve("run.mcap")), StandardCharsets.UTF_8))
        .contains("ros2", "ros2msg", "MSG: geometry_msgs/TransformStamped");
    Path file = Files.writeString(folder.resolve("taken"), "");
    assertThat(Cli.run("record", "hello", "--seed", "1", "--rosbag", "--out", "" + file).messages())
        .singleElement()
        .asString()
        .contains("'" + file + "/run.mcap': cannot be written ('" + file + "' is a file already)");
  }

  @Test
  void withoutAViolationNoPictureIsWritten() {
    for (String kind : new String[] {"--png", "--gif"}) {
      Path file = folder.resolve("none" + kind);
      Cli cli =
          Cli.run(
              "record",
              "hello",
              "--seed",
              "1",
              kind,
              "--when",
              "violation",
              "--out",
              file.toString());
      assertThat(cli.status()).isZero();
      assertThat(cli.text()).contains("no specification was violated");
      assertThat(file).doesNotExist();
    }
  }

  /** As the format's specification has it: the magic, records behind their lengths, the magic. */
  @Test
  void anMcapFileIsMadeOfWholeRecords() throws IOException {
    Path mcap = folder.resolve("a.mcap");
    Cli cli = Cli.run("record", "hello", "--seed", "1", "--mcap", "--out", mcap.toString());
    assertThat(cli.status()).isZero();
    byte[] bytes = Files.readAllBytes(mcap);
    byte[] magic = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
    assertThat(bytes).startsWith(magic).endsWith(magic);
    ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    in.position(magic.length);
    StringBuilder kinds = new StringBuilder();
    while (in.remaining() > magic.length) {
      kinds.append(Integer.toHexString(in.get()));
      int length = Math.toIntExact(in.getLong());
      in.position(in.position() + length);
    }
    assertThat(in.remaining()).isEqualTo(magic.length);
    assertThat(kinds.toString()).matches("1c67+f3+4+b8+de+2");
    assertThat(new String(bytes, StandardCharsets.UTF_8))
        .contains("foxglove.SceneUpdate", "/pose/bot0");
  }

  @Test
  void aPictureAfterTheEndOfTheRunSaysSo() {
    for (String moment : new String[] {"--png", "--when"}) {
      Path file = folder.resolve("late.png");
      Cli cli = Cli.run("record", "hello", "--seed", "1", moment, "t=400s", "--out", "" + file);
      assertThat(cli.status()).isZero();
      assertThat(file).exists();
      assertThat(cli.messages())
          .singleElement()
          .asString()
          .matches("t=400s: the run ended before, at [0-9.]+ s; the picture shows its end");
    }
    Path file = folder.resolve("early.png");
    assertThat(Cli.run("record", "hello", "--seed", "1", "--png", "t=1s", "--out", "" + file).err())
        .isEmpty();
  }

  @Test
  void runsOfOtherSettingsHaveOtherFiles() {
    assertThat(file()).isEqualTo("out/hello-7.png");
    Set<String> files = new TreeSet<>();
    for (int robots = 1; robots <= 9; robots++) {
      String file = file("--robots", "" + robots);
      assertThat(file)
          .matches("out/hello-7-[0-9a-f]{8}[.]png")
          .isEqualTo(file("--robots", "" + robots));
      files.add(file);
    }
    files.add(file("--fault", "crash(bot1,at=2s)"));
    assertThat(files).hasSize(10);
  }

  private static String file(String... words) {
    List<String> all = new ArrayList<>(List.of("hello"));
    all.addAll(List.of(words));
    return RunRequestTest.request(all).file(7, "png");
  }
}
