package org.starl.android.apk;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The code that a phone gets: it is D8's, and no longer what javac made. */
@Tag("long")
class DexedCodeTest {

  /** All that the app asks of newer versions of Android, each behind a question for the version. */
  private static final List<String> ASKED_BEFORE =
      List.of(
          "org/starl/android/app/RobotService ->"
              + " org/starl/android/app/RobotService.startForeground(ILandroid/app/Notification;I)V");

  private static final String CLASS_PATH = System.getProperty("java.class.path");

  @TempDir static Path folder;
  private static byte[] trace;
  private static SortedMap<String, byte[]> apk;
  private static DexedCode dexed;

  @BeforeAll
  static void dexWhatTheApkHoldsAndTheSimulatorThatRunsIt()
      throws ApkException, IOException, ReflectiveOperationException {
    OwnClasses compiled = OwnClasses.compiled();
    trace = trace(compiled);
    apk = Selection.of(CLASS_PATH).classes();
    SortedMap<String, byte[]> all = new TreeMap<>(apk);
    for (String name : compiled.needed()) {
      all.putIfAbsent(name + ".class", OwnClasses.compiled(name));
    }
    dexed = DexedCode.of(all, folder);
  }

  private static byte[] trace(OwnClasses classes) throws ReflectiveOperationException {
    Object run = classes.loadClass(CrossingTrace.class.getName()).getConstructor().newInstance();
    return (byte[]) ((Supplier<?>) run).get();
  }

  /** Classes that are not in the APK and were not needed by the first run are used as compiled. */
  private static byte[] returned(String name) throws IOException {
    byte[] bytes = dexed.classes().get(name);
    return bytes == null && !apk.containsKey(name + ".class") ? OwnClasses.compiled(name) : bytes;
  }

  /**
   * The given classes that are in the APK too; D8 names its additions after the class that needs
   * them.
   */
  private static List<String> ofTheApk() {
    return dexed.classes().keySet().stream()
        .filter(name -> apk.containsKey(name.replaceFirst("\\$\\$.*", "") + ".class"))
        .toList();
  }

  @Test
  void aRunOfDexedCodeGivesTheSameTrace() throws ReflectiveOperationException, IOException {
    OwnClasses returned = new OwnClasses(DexedCodeTest::returned);
    byte[] again = trace(returned);
    assertThat(returned.needed()).filteredOn(dexed.classes()::containsKey).hasSizeGreaterThan(200);
    assertThat(new String(trace, StandardCharsets.UTF_8))
        .contains("\"name\":\"location\",\"value\":\"DONE\"");
    assertThat(new String(again, StandardCharsets.UTF_8))
        .isEqualTo(new String(trace, StandardCharsets.UTF_8));
  }

  @Test
  void theApkRefersOnlyToMembersOfAndroid8() throws ApkException, IOException {
    assertThat(ofTheApk()).hasSizeGreaterThan(1000);
    SortedSet<String> missing =
        Links.missing(dexed.classes(), ofTheApk(), Android8.shapes(CLASS_PATH));
    assertThat(missing).containsExactlyElementsOf(ASKED_BEFORE);
  }

  /** Asks for a class and a method that are newer than Android 8, and inherits a third. */
  private static final class AsksForMore extends ArrayList<String> {
    private static final long serialVersionUID = 1L;

    Object ask() {
      return Thread.ofVirtual();
    }

    String askMyself() {
      return getFirst();
    }
  }

  @Test
  void missingMembersOfAndroid8AreFound() throws ApkException, IOException {
    String name = AsksForMore.class.getName().replace('.', '/');
    SortedMap<String, byte[]> alone = new TreeMap<>();
    alone.put(name, OwnClasses.compiled(name));
    assertThat(Links.missing(alone, alone.keySet(), Android8.shapes(CLASS_PATH)))
        .containsExactlyInAnyOrder(
            name + " -> java/lang/Thread$Builder$OfVirtual",
            name + " -> java/lang/Thread.ofVirtual()Ljava/lang/Thread$Builder$OfVirtual;",
            name + " -> " + name + ".getFirst()Ljava/lang/Object;");
  }
}
