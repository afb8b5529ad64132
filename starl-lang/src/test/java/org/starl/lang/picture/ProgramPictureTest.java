package org.starl.lang.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Program;

class ProgramPictureTest {

  private static final String LIGHT =
      """
      program Light
      uses moat: Motion
      given there: Places
      state on: bool := false
      location Dark
        when not on and moat.done do on := true; goto Bright
        do goto Bright
      location Bright
        when on do on := false; moat.do_move(there); goto Dark
        when moat.failed do goto Bright
        do goto End
      location End
      """;

  private static final Pattern TEXT =
      Pattern.compile("<text x=\"(\\d+)\" y=\"(\\d+)\"( text-anchor)?[^>]*>([^<]*)</text>");
  private static final Pattern PATH = Pattern.compile("<path d=\"([^\"]*)\" fill=\"none\"");
  private static final Pattern SIZE = Pattern.compile("width=\"(\\d+)\" height=\"(\\d+)\"");

  @TempDir private Path folder;

  /** A rectangle; of a line, one without an area. */
  private record Area(int left, int top, int right, int bottom) {
    boolean meets(Area that) {
      return left < that.right && that.left < right && top < that.bottom && that.top < bottom;
    }
  }

  private Program light() throws IOException, SourceErrors {
    Path file = Files.writeString(folder.resolve("light.starl"), LIGHT);
    return new SourceReader().source(file).programs().getFirst();
  }

  @Test
  void everyLocationGuardAndStatementIsShown() throws IOException, SourceErrors {
    String svg = ProgramPicture.of(light());
    assertThat(texts(svg))
        .containsExactlyInAnyOrder(
            "Dark",
            "Bright",
            "End",
            "not on and moat.done",
            "on := true",
            "on",
            "on := false",
            "moat.do_move(there)",
            "moat.failed");
    // Each branch has an arrow, and the start; the two from Dark to Bright have one.
    assertThat(PATH.matcher(svg).results()).hasSize(1 + 5 - 1);
    assertThat(svg).isEqualTo(ProgramPicture.of(light()));
  }

  private static List<String> texts(String svg) {
    return TEXT.matcher(svg).results().map(each -> each.group(4)).toList();
  }

  static IntStream seeds() {
    return IntStream.range(0, 200);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void noLineCrossesATextAndNoTextAnother(int seed) {
    String svg = random(new SplittableRandom(seed)).svg("random");
    List<Area> texts = TEXT.matcher(svg).results().map(ProgramPictureTest::area).toList();
    List<Area> lines = new ArrayList<>();
    PATH.matcher(svg).results().forEach(each -> lines.addAll(segments(each.group(1))));
    MatchResult size = SIZE.matcher(svg).results().findFirst().orElseThrow();
    int width = Integer.parseInt(size.group(1));
    int height = Integer.parseInt(size.group(2));
    for (int i = 0; i < texts.size(); i++) {
      Area text = texts.get(i);
      assertThat(text.left >= 0 && text.top >= 0 && text.right <= width && text.bottom <= height)
          .as("%s in %d x %d\n%s", text, width, height, svg)
          .isTrue();
      assertThat(lines).as("%s\n%s", text, svg).noneMatch(text::meets);
      assertThat(texts.subList(i + 1, texts.size())).as("%s\n%s", text, svg).noneMatch(text::meets);
    }
  }

  private static Column random(SplittableRandom rng) {
    int boxes = rng.nextInt(1, 9);
    List<Arrow> arrows = new ArrayList<>();
    int all = rng.nextInt(3 * boxes);
    for (int i = 0; i < all; i++) {
      arrows.add(
          new Arrow(i, rng.nextInt(boxes), rng.nextInt(boxes), lines(rng, "g"), lines(rng, "e")));
    }
    List<String> names = IntStream.range(0, boxes).mapToObj(i -> "location" + i).toList();
    return new Column(names, arrows);
  }

  private static List<String> lines(SplittableRandom rng, String letter) {
    return IntStream.range(0, rng.nextInt(4))
        .mapToObj(i -> letter.repeat(rng.nextInt(1, 45)))
        .toList();
  }

  private static Area area(MatchResult text) {
    int x = Integer.parseInt(text.group(1));
    int y = Integer.parseInt(text.group(2));
    int width = Svg.widthOf(text.group(4));
    int left = text.group(3) == null ? x : x - width / 2;
    return new Area(left, y - 10, left + width, y + 3);
  }

  /** Of {@code M1 2H3V4}. */
  private static List<Area> segments(String path) {
    List<Area> segments = new ArrayList<>();
    int x = 0;
    int y = 0;
    for (MatchResult step :
        Pattern.compile("([MHV])(\\d+)(?: (\\d+))?").matcher(path).results().toList()) {
      int to = Integer.parseInt(step.group(2));
      int beforeX = x;
      int beforeY = y;
      x = step.group(1).equals("V") ? x : to;
      y =
          step.group(1).equals("H")
              ? y
              : step.group(1).equals("V") ? to : Integer.parseInt(step.group(3));
      if (!step.group(1).equals("M")) {
        segments.add(
            new Area(
                Math.min(x, beforeX) - 1,
                Math.min(y, beforeY),
                Math.max(x, beforeX) + 1,
                Math.max(y, beforeY) + 1));
      }
    }
    return segments;
  }
}
