plugins {
    `java-library`
    id("maven-publish")
}

description = "The six demo apps with their scenarios and drawers"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-core-input"))
    api(project(":starl-primitives"))
    api(project(":starl-sim"))
    api(project(":starl-sim-view"))
    api(libs.jspecify)
    implementation(libs.batik.bridge)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

configurations.configureEach {
    // The JDK has its interfaces.
    exclude(mapOf("group" to "xml-apis", "module" to "xml-apis"))
}
