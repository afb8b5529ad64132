plugins {
    application
    id("maven-publish")
}

description = "Makes, signs and verifies the APK of the app for phones"

dependencies {
    implementation(project(":starl-android-app"))
    // Android's resources and classes: what the APK is linked against.
    runtimeOnly(libs.android.resources)
    implementation(libs.r8)
    implementation(libs.apksig)
    implementation(libs.picocli)
    testImplementation(project(":starl-apps"))
    testImplementation(project(":starl-sim"))
    // Makes class files of dex.
    testImplementation(libs.dex.translator)
    // Reads the list of what Android 8 has.
    testImplementation(libs.animal.sniffer)
    testRuntimeOnly(variantOf(libs.gummy.bears) { artifactType("signature") })
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
