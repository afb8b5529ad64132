package org.starl.sim.view.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class FrameEncoderTest {

  /** Lists of ellipses with few different numbers, so that much is equal or only moved. */
  @Provide
  Arbitrary<List<List<int[]>>> pictures() {
    Arbitrary<int[]> item =
        Arbitraries.integers()
            .between(0, 2)
            .array(int[].class)
            .ofSize(5)
            .map(numbers -> {
              int[] ellipse = new int[6];
              ellipse[0] = DrawnItem.ELLIPSE;
              System.arraycopy(numbers, 0, ellipse, 1, 5);
              return ellipse;
            });
    Arbitrary<int[]> line =
        Arbitraries.integers()
            .between(0, 2)
            .array(int[].class)
            .ofMinSize(2)
            .ofMaxSize(8)
            .map(numbers -> Arrays.copyOf(numbers, numbers.length / 2 * 2))
            .map(numbers -> {
              numbers[0] = DrawnItem.LINE;
              return numbers;
            });
    return Arbitraries.oneOf(item, line).list().ofMaxSize(5).list().ofMinSize(1).ofMaxSize(6);
  }

  /** What the page's script does. */
  private static List<int[]> decoded(List<int[]> before, List<Object> changes) {
    if (changes.isEmpty()) {
      return before;
    }
    List<int[]> items = new ArrayList<>();
    for (Object change : changes) {
      if (change instanceof Integer same) {
        items.addAll(before.subList(items.size(), items.size() + same));
      } else if (change instanceof int[] numbers && numbers[0] < 0) {
        int[] item = items.get(items.size() - 1).clone();
        item[1] = numbers[1];
        for (int i = item[0] == DrawnItem.ELLIPSE ? 4 : 2; i < item.length; i += 2) {
          item[i] += numbers[2];
          item[i + 1] += numbers[3];
        }
        items.add(item);
      } else if (change instanceof int[] numbers) {
        int[] old = items.size() < before.size() ? before.get(items.size()) : new int[0];
        int middle = numbers.length - 2;
        int[] item = new int[numbers[0] + middle + numbers[1]];
        System.arraycopy(old, 0, item, 0, numbers[0]);
        System.arraycopy(numbers, 2, item, numbers[0], middle);
        System.arraycopy(old, old.length - numbers[1], item, numbers[0] + middle, numbers[1]);
        items.add(item);
      }
    }
    return items;
  }

  @Property
  void theDifferencesGiveThePicturesAgain(@ForAll("pictures") List<List<int[]>> pictures) {
    FrameEncoder encoder = new FrameEncoder();
    List<int[]> shown = List.of();
    for (List<int[]> picture : pictures) {
      shown = decoded(shown, encoder.next(picture));
      assertThat(shown).usingRecursiveComparison().isEqualTo(picture);
    }
  }

  @Test
  void aTrailThatGrowsCostsItsNewPointsOnly() {
    FrameEncoder encoder = new FrameEncoder();
    encoder.next(List.of(new int[] {DrawnItem.LINE, 7, 0, 0, 10, 10, 20, 20}));
    List<Object> grown =
        encoder.next(List.of(new int[] {DrawnItem.LINE, 7, 0, 0, 10, 10, 20, 20, 31, 30}));
    assertThat(grown).hasSize(1);
    assertThat((int[]) grown.get(0)).containsExactly(8, 0, 31, 30);
  }
}
