package org.starl.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Values of which no shape is known. */
class JsonReaderTest {

  @Provide
  Arbitrary<String> strings() {
    return Samples.strings();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0",
        "-12.5E-7",
        "true",
        "false",
        "null",
        "\"\"",
        "\"a\\\"]},{\\\\\"",
        "[]",
        "{}",
        "[1,[2,[]],{\"a\":[{}],\"}\":\"{\"}]",
        "{\"a\":{\"b\":{\"c\":[null,true,\"]\"]}}}"
      })
  void aValueIsReadAsItIs(String json) throws JsonFormatException {
    JsonReader in = new JsonReader("a.trace", 1, json + ",\"next\":1}");
    assertThat(in.value()).isEqualTo(json);
    in.expect(",\"next\":1}");
    in.expectEnd();
  }

  @Property
  void aStringIsReadAsItIs(@ForAll("strings") String text) throws JsonFormatException {
    String json = Shapes.TEXT.json(text);
    JsonReader in = new JsonReader("a.trace", 1, json + "]");
    assertThat(in.value()).isEqualTo(json);
    in.expect("]");
    assertThat(new JsonReader("a.trace", 1, json).text("")).isEqualTo(text);
    assertThat(Json.string(text)).isEqualTo(new Json(json));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " 1", "x", "[1", "{\"a\":", "[1 ,2]", "]", "}", ",", ":", "\"a"})
  void whatIsNoValueIsRefused(String text) {
    assertThatExceptionOfType(JsonFormatException.class)
        .isThrownBy(() -> new JsonReader("a.trace", 3, text).value())
        .withMessageStartingWith("a.trace:3: column 1: expected a ");
  }
}
