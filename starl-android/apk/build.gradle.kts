plugins {
    application
    id("maven-publish")
}

description = "Makes, signs and verifies the APK of the app for phones"

dependencies {
    implementation(project(":starl-android-app"))
    implementation(project(":starl-apps"))
    // Android's resources and classes: what the APK is linked against.
    runtimeOnly(libs.android.resources)
    implementation(libs.r8)
    implementation(libs.apksig)
    // Reads the list of what Android 8 has.
    implementation(libs.animal.sniffer)
    runtimeOnly(variantOf(libs.gummy.bears) { artifactType("signature") })
    implementation(libs.picocli)
    testImplementation(project(":starl-sim"))
    // Writes the project whose APK a test makes.
    testImplementation(project(":starl-cli"))
    // Makes class files of dex.
    testImplementation(libs.dex.translator)
    implementation(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

tasks.withType<Test>().configureEach {
    // D8 is run once: to compile it well takes longer than to run it.
    jvmArgs("-XX:TieredStopAtLevel=1")
}

application {
    mainClass.set("org.starl.android.apk.Main")
    applicationName = "starl-apk"
}
