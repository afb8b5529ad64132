package org.starl.apps.lightpaint.logic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** What a painter tells its trace and the other painters. */
class PaintFactTest {

  private static final Light ON = new Light(7, new Ink(0xff8800, 25));

  @Test
  void aLightIsReadFromJson() throws JsonFormatException {
    for (Light light : List.of(Light.OFF, ON)) {
      String json = Light.SHAPE.json(light);
      assertThat(Light.SHAPE.readJson(new JsonReader("trace", 1, json))).as(json).isEqualTo(light);
    }
  }

  @Test
  void aLightIsAShortText() {
    assertThat(Light.OFF).hasToString("off");
    assertThat(ON).hasToString("7 #ff8800 25.0");
  }

  /** Robots of several versions must understand each other. */
  @Test
  void theBytesOfAHintStayTheSame() {
    Hint hint = new Hint(3, true, 2, 100);
    byte[] bytes = WireWriter.toBytes(out -> Hint.SHAPE.write(hint, out));
    assertThat(HexFormat.of().formatHex(bytes))
        .isEqualTo("00000003" + "01" + "00000002" + "00000064");
    assertThat(Hint.SHAPE.read(new WireReader(bytes))).isEqualTo(hint);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "fffffffe" + "01" + "00000002" + "00000064",
        "00000003" + "02" + "00000002" + "00000064",
        "00000003" + "01" + "ffffffff" + "00000064",
        "00000003" + "01" + "00000002" + "ffffffff",
        "00000003" + "01",
      })
  void otherBytesAreNoHint(String hex) {
    WireReader in = new WireReader(HexFormat.of().parseHex(hex));
    assertThatThrownBy(() -> Hint.SHAPE.read(in)).isInstanceOf(WireFormatException.class);
  }
}
