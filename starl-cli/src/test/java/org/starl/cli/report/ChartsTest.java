package org.starl.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Size;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/** Charts show their values. */
class ChartsTest {

  private static Document sizes(List<Double> values) throws Exception {
    Html html = new Html().open("main");
    new SizeCharts(html, "wait", "s", Distribution.of(values)).write();
    return Parsed.page(html.close().page());
  }

  /** The titles of bars and points, without those of whole drawings. */
  private static List<String> tips(Document page) {
    return Parsed.elements(page, "title").stream()
        .filter(title -> !title.getParentNode().getNodeName().equals("svg"))
        .map(Element::getTextContent)
        .toList();
  }

  private static List<String> cells(Document page) {
    return Parsed.elements(page, "td").stream().map(Element::getTextContent).toList();
  }

  @Property(tries = 200)
  void barsCountEachValueOnceUnlessItIsLeftOut(
      @ForAll @Size(min = 1, max = 60) List<@DoubleRange(min = 0, max = 100) Double> values)
      throws Exception {
    Document page = sizes(values);
    int counted =
        tips(page).stream()
            .filter(tip -> tip.contains(" to ") && tip.contains(": "))
            .mapToInt(tip -> Integer.parseInt(tip.replaceAll(".*: (\\d+) \\(.*", "$1")))
            .sum();
    Distribution spread = Distribution.of(values);
    int below = spread.upTo(spread.chartLimit());
    assertThat(counted).isBetween(below, values.size());
    assertThat(page.getDocumentElement().getTextContent().contains("Left out"))
        .isEqualTo(below < values.size());
    assertThat(Parsed.elements(page, "rect"))
        .noneMatch(rect -> rect.getAttribute("width").startsWith("-"))
        .noneMatch(rect -> rect.getAttribute("height").startsWith("-"));
  }

  @Example
  void percentilesStandInTheTable() throws Exception {
    List<Double> values = IntStream.rangeClosed(1, 100).mapToObj(i -> i / 10.0).toList();
    assertThat(cells(sizes(values)))
        .containsExactly(
            "100", "0.10", "0.50", "2.5", "5.0", "7.5", "9.0", "9.5", "9.9", "10.0", "5.1");
  }

  @Example
  void equalValuesAndNothingButZeroCanBeDrawn() throws Exception {
    assertThat(cells(sizes(List.of(0.0, 0.0)))).contains("2", "0");
    assertThat(cells(sizes(List.of(3.0, 3.0, 3.0)))).contains("3", "3.0");
    assertThat(cells(sizes(List.of(1e-12)))).contains("1");
  }

  @Example
  void farOutliersAreLeftOutAndCounted() throws Exception {
    List<Double> values = new ArrayList<>(IntStream.range(0, 200).mapToObj(i -> 1.0).toList());
    values.add(5000.0);
    String text = sizes(values).getDocumentElement().getTextContent();
    assertThat(text).contains("Left out: 1 of 201, above 1.0\u00A0s.");
  }

  @Example
  void timesAreCountedRunByRun() throws Exception {
    Html html = new Html().open("main");
    List<List<Double>> runs =
        List.of(List.of(5.0, 15.0), List.of(9.0, 25.0), List.of(12.0), List.of(), List.of(1.0));
    new TimeChart(html, "crossings", runs).write();
    Document page = Parsed.page(html.close().page());
    assertThat(cells(page))
        .containsExactly(
            "5\u00A0s",
            "0",
            "0",
            "1",
            "2",
            "10\u00A0s",
            "0",
            "1",
            "1",
            "3",
            "15\u00A0s",
            "0",
            "1",
            "2",
            "5",
            "20\u00A0s",
            "0",
            "1",
            "2",
            "5",
            "25\u00A0s",
            "0",
            "1",
            "2",
            "6");
    assertThat(tips(page)).hasSize(40).allMatch(tip -> tip.matches("at [0-9.]+\u00A0s: .*"));
  }
}
