package org.starl.build;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import java.util.Set;

/**
 * What {@code javac --release 21} accepts and Android 8 lacks, as far as an app's logic is tempted
 * by it, told where it is written. All that a phone runs is checked against Android's own list when
 * the APK's tests are run, after D8.
 */
final class AndroidGaps {

  private static final Set<String> MEMBERS =
      Set.of(
          "java.util.List.getFirst",
          "java.util.List.getLast",
          "java.util.List.removeFirst",
          "java.util.List.removeLast",
          "java.util.List.addFirst",
          "java.util.List.addLast",
          "java.util.List.reversed",
          "java.util.ArrayList.getFirst",
          "java.util.ArrayList.getLast",
          "java.util.ArrayList.removeFirst",
          "java.util.ArrayList.removeLast",
          "java.util.ArrayList.addFirst",
          "java.util.ArrayList.addLast",
          "java.util.stream.Stream.toList",
          "java.util.stream.Stream.mapMulti",
          "java.util.stream.Stream.takeWhile",
          "java.util.stream.Stream.dropWhile",
          "java.lang.String.repeat",
          "java.lang.String.strip",
          "java.lang.String.isBlank",
          "java.lang.String.lines",
          "java.lang.String.formatted",
          "java.lang.Math.clamp",
          "java.lang.StrictMath.clamp",
          "java.lang.Thread.ofVirtual",
          "java.lang.Thread.startVirtualThread",
          "java.time.Duration.toSeconds");
  private static final Set<String> TYPES =
      Set.of(
          "java.lang.ProcessHandle",
          "java.util.SequencedCollection",
          "java.util.SequencedMap",
          "java.util.SequencedSet",
          "java.util.random.RandomGenerator");

  static final DescribedPredicate<JavaAccess<?>> ACCESS =
      DescribedPredicate.describe(
          "what Android 8 lacks",
          access -> {
            String owner = access.getTargetOwner().getName();
            return TYPES.contains(owner) || MEMBERS.contains(owner + "." + access.getName());
          });

  private AndroidGaps() {}
}
