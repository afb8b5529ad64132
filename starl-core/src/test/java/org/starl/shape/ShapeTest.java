package org.starl.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

class ShapeTest {

  private static final RobotId BOT = new RobotId("bot0");

  @Provide
  Arbitrary<Sample> wellFormed() {
    return Samples.of(Samples.wellFormed());
  }

  @Provide
  Arbitrary<Sample> samples() {
    return Samples.of(Samples.strings());
  }

  private static <T> byte[] bytes(Shape<T> shape, T value) {
    return WireWriter.toBytes(out -> shape.write(value, out));
  }

  private static <T> T readJson(Shape<T> shape, String json) throws JsonFormatException {
    JsonReader in = new JsonReader("a.trace", 7, json);
    T value = shape.readJson(in);
    in.expectEnd();
    return value;
  }

  @Property
  void aValueIsReadBackFromItsBytes(@ForAll("wellFormed") Sample value) {
    WireReader in = new WireReader(bytes(Sample.SHAPE, value));
    assertThat(Sample.SHAPE.read(in)).isEqualTo(value);
    in.expectEnd();
  }

  @Property
  void aValueIsReadBackFromItsJson(@ForAll("samples") Sample value) throws JsonFormatException {
    assertThat(readJson(Sample.SHAPE, Sample.SHAPE.json(value))).isEqualTo(value);
  }

  @Property
  void theJsonIsOneValue(@ForAll("samples") Sample value) throws JsonFormatException {
    String json = Sample.SHAPE.json(value);
    assertThat(readJson(Shapes.JSON, json)).isEqualTo(new Json(json));
  }

  @Property
  void bytesAreAValueOrRefused(@ForAll @Size(max = 60) byte[] bytes) {
    Sample value;
    try {
      value = Sample.SHAPE.read(new WireReader(bytes));
    } catch (WireFormatException refused) {
      return;
    }
    byte[] again = bytes(Sample.SHAPE, value);
    assertThat(Sample.SHAPE.read(new WireReader(again))).isEqualTo(value);
  }

  @Test
  void eachRecordOfASumHasItsNumberAndItsName() {
    assertThat(bytes(Sample.SHAPE, new Sample.Nothing())).containsExactly(1);
    assertThat(Sample.SHAPE.json(new Sample.Nothing())).isEqualTo("{\"Nothing\":{}}");
    Sample numbers = new Sample.Numbers(255, 65_535, -1, 1, -0.5, true);
    assertThat(bytes(Sample.SHAPE, numbers))
        .containsExactly(
            2, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 1, 0xBF, 0xE0, 0, 0, 0, 0, 0,
            0, 1);
    assertThat(Sample.SHAPE.json(numbers))
        .isEqualTo(
            "{\"Numbers\":{\"small\":255,\"medium\":65535,\"number\":-1,\"large\":1,"
                + "\"real\":-0.5,\"isSo\":true}}");
    ProcessId process = ProcessId.first(BOT, 2);
    Sample.Place place = new Sample.Place(1e9, 0.1);
    assertThat(
            Sample.SHAPE.json(new Sample.Names("a\"b", BOT, process, Sample.Colour.GREEN, place)))
        .isEqualTo(
            "{\"do_name\":{\"text\":\"a\\\"b\",\"robot\":\"bot0\",\"process\":\"bot0.2\","
                + "\"colour\":\"GREEN\",\"place\":{\"xMm\":1.0E9,\"yMm\":0.1}}}");
  }

  @Test
  void setsAndMapsAreInAscendingOrder() {
    Sample.Several several =
        new Sample.Several(
            List.of("x"),
            new TreeSet<>(List.of(3L, -1L)),
            new TreeMap<>(Collections.singletonMap(BOT, List.of())),
            Optional.empty(),
            Optional.of(new Sample.Numbers(0, 0, 0, 0, 0, false)));
    assertThat(Sample.SEVERAL.json(several))
        .isEqualTo(
            "{\"list\":[\"x\"],\"set\":[-1,3],\"map\":[{\"key\":\"bot0\",\"value\":[]}],"
                + "\"text\":null,\"inner\":{\"Numbers\":{\"small\":0,\"medium\":0,\"number\":0,"
                + "\"large\":0,\"real\":0.0,\"isSo\":false}}}");
    // A set of more than 255 elements can be, so its length has two bytes.
    assertThat(bytes(Shapes.set(Shapes.U8, 256), new TreeSet<>(List.of(7, 5))))
        .containsExactly(0, 2, 5, 7);
  }

  private static <T> String refusal(Shape<T> shape, String json) {
    JsonFormatException error =
        catchThrowableOfType(JsonFormatException.class, () -> readJson(shape, json));
    assertThat(error).as(json).isNotNull();
    return String.valueOf(error.getMessage());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '\0',
      value = {
        "{\"Nothing\":{} }|column 14: expected }, found  }",
        "{\"Other\":{}}|expected a known Sample, found Other",
        "{\"Numbers\":{\"medium\":1}}|column 13: expected \"small\":, found \"medium\":1}}",
        "{\"Numbers\":{\"small\":x}}|column 21: expected a digit, found x}}",
        "{\"do_name\":{\"text\":1}}|column 20: expected a string, found 1}}",
        "{\"do_name\":{\"text\":\"\",\"robot\":\"0\"}}|expected a robot's name, found \"0\"}}",
        "{\"Several\":{\"list\":[1]}}|column 21: expected a string, found 1]}}",
        "{\"Several\":{\"list\":[],\"set\":[3,-1]}}|-1 after 3",
      })
  void malformedJsonIsToldWithItsPlace(String json, String problem) {
    assertThat(refusal(Sample.SHAPE, json)).startsWith("a.trace:7: ").endsWith(problem);
  }

  @Test
  void whatAConstructorRefusesIsMalformed() {
    assertThat(refusal(Sample.Span.SHAPE, "{\"x\":3,\"y\":2}"))
        .isEqualTo("a.trace:7: column 12: x 3 after y 2");
    assertThatExceptionOfType(WireFormatException.class)
        .isThrownBy(
            () -> Sample.Span.SHAPE.read(new WireReader(new byte[] {0, 0, 0, 3, 0, 0, 0, 2})))
        .withMessage("x 3 after y 2");
  }

  @Test
  void whatAConditionRefusesIsMalformed() {
    Shape<Long> positive = Shapes.atLeast(1, "count");
    assertThat(refusal(positive, "0")).isEqualTo("a.trace:7: column 1: count 0");
    assertThatExceptionOfType(WireFormatException.class)
        .isThrownBy(() -> positive.read(new WireReader(new byte[8])))
        .withMessage("count 0");
  }

  @Test
  void anUnknownConstantIsMalformed() {
    Shape<Sample.Colour> colour = Shapes.constant(Sample.Colour.class);
    assertThat(refusal(colour, "\"BLUE\"")).startsWith("a.trace:7: ").contains("BLUE");
    assertThatExceptionOfType(WireFormatException.class)
        .isThrownBy(() -> colour.read(new WireReader(new byte[] {2})));
  }

  @Test
  void aListThatIsTooLongIsMalformed() {
    Shape<List<Integer>> two = Shapes.list(Shapes.U8, 2);
    assertThat(two.read(new WireReader(new byte[] {2, 8, 9}))).containsExactly(8, 9);
    assertThatExceptionOfType(WireFormatException.class)
        .isThrownBy(() -> two.read(new WireReader(new byte[] {3, 8, 9, 10})));
  }

  @Test
  void aRecordThatIsNotInASumIsABugOfTheCaller() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Sample.INNER.json(new Sample.Nothing()))
        .withMessageContaining("Nothing")
        .withMessageContaining("expected one of Numbers");
  }

  @Test
  void aShapeTellsItsPartsToPeople() {
    assertThat(Sample.Place.SHAPE).hasToString("Place(xMm: f64, yMm: f64)");
    Sample.Place place = new Sample.Place(1, 2);
    assertThat(Sample.Place.SHAPE.values(place)).containsExactly(1.0, 2.0);
    assertThat(Sample.Place.SHAPE.first(place)).isEqualTo(1.0);
    assertThat(Sample.NOTHING.first(new Sample.Nothing())).isNull();
    assertThat(Sample.SHAPE.describe()).isEqualTo("Nothing or Numbers or do_name or Several");
  }

  @Test
  void aRecordOfUnknownShapeKeepsItsJson() throws JsonFormatException {
    RecordShape<Json> unknown = RecordShape.unknown("x");
    String json = "{\"a\":[1,{\"b\":null}]}";
    Json value = readJson(unknown, json);
    assertThat(unknown.json(value)).isEqualTo(json);
    assertThat(unknown.values(value)).containsExactly(new Json(json));
  }

  @Test
  void listsAndSetsThatWereReadCannotBeChanged() {
    List<Integer> list = Shapes.list(Shapes.U8, 9).read(new WireReader(new byte[] {1, 5}));
    assertThat(list).isUnmodifiable();
    var set = Shapes.set(Shapes.U8, 9).read(new WireReader(new byte[] {1, 5}));
    assertThatExceptionOfType(UnsupportedOperationException.class).isThrownBy(() -> set.add(6));
  }
}
