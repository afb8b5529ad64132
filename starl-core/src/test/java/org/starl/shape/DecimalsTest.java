package org.starl.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalsTest {

  @Provide
  Arbitrary<Double> numbers() {
    return Samples.numbers();
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0.000",
    "-0.0, 0.000",
    "0.0005, 0.001",
    "-0.0005, -0.001",
    "-0.0004, 0.000",
    "0.00049999999999999994, 0.000",
    "0.9996, 1.000",
    "-12.3456, -12.346",
    "1234567890.125, 1234567890.125",
    "999999999999.9995, 1000000000000.000",
    "1e12, 1000000000000.000",
    "-9007199254740993, -9007199254740992.000",
    "1e21, 1000000000000000000000.000",
    "4.9e-324, 0.000"
  })
  void millimetresHaveThreeDecimals(double value, String text) {
    assertThat(text(value, Decimals.MM)).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource({
    "3.141592653589793, 3.141593",
    "-1.5707963267948966, -1.570796",
    "1e9, 1000000000.000000"
  })
  void anglesHaveSixDecimals(double value, String text) {
    assertThat(text(value, Decimals.RAD)).isEqualTo(text);
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void nonFiniteNumbersAreRefused(double value) {
    assertThatThrownBy(() -> text(value, Decimals.MM)).hasMessageContaining("" + value);
  }

  @Property
  void theTextIsWithinHalfAUnitOfTheNumber(@ForAll("numbers") double value) {
    BigDecimal off = new BigDecimal(text(value, Decimals.MM)).subtract(new BigDecimal(value));
    // A product of doubles decides on which side a number very near a half lies.
    BigDecimal slack = new BigDecimal(Math.ulp(value));
    assertThat(off.abs()).isLessThanOrEqualTo(new BigDecimal("0.0005").add(slack));
  }

  @Property
  void theRoundedNumberIsTheOneNearestToTheText(@ForAll("numbers") double value) {
    assertThat(Decimals.round(value, Decimals.MM))
        .isEqualTo(Double.parseDouble(text(value, Decimals.MM)));
  }

  @Property
  void roundingIsIdempotent(@ForAll("numbers") double value) {
    double once = Decimals.round(value, Decimals.RAD);
    assertThat(Decimals.round(once, Decimals.RAD)).isEqualTo(once);
    assertThat(text(once, Decimals.RAD)).isEqualTo(text(value, Decimals.RAD));
  }

  private static String text(double value, int decimals) {
    JsonWriter out = new JsonWriter();
    Decimals.append(out, value, decimals);
    return out.textFrom(0);
  }
}
